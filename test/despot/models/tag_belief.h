// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tag.h"
#include "weighted_states.h"

namespace pomdp_crowd_nav {

// The exact belief. Once the robot knows its own cell these are 29 numbers; before, 841.
class TagBelief {
 public:
  using Model = Tag;

  explicit TagBelief(const Tag&) { probability_.fill(1.0 / kStates); }

  double probability(int robot, int opponent) const {
    return probability_[robot * TagFloor::kCells + opponent];
  }

  std::vector<WeightedState<Tag::State>> states() const {
    std::vector<WeightedState<Tag::State>> all;
    for (int i = 0; i < kStates; ++i) {
      if (probability_[i] > 0.0) all.push_back({stateAt(i), probability_[i]});
    }
    return all;
  }

  void update(const Tag&, Tag::Action action, std::uint64_t observation) {
    std::array<double, kStates> updated{};
    double sum = 0.0;
    for (const auto& before : states()) {
      const Tag::State& from = before.state;
      if (action == Tag::kTag && from.robot == from.opponent) continue;  // it would be over
      const int to = action == Tag::kTag ? from.robot : TagFloor::moved(from.robot, action);
      const auto moves = opponentMoves(from.robot, from.opponent);
      for (int d = 0; d <= TagFloor::kStay; ++d) {
        const int i = to * TagFloor::kCells + TagFloor::moved(from.opponent, d);
        if (Tag::observationOf(stateAt(i)) != observation) continue;
        updated[i] += before.weight * moves[d];
        sum += before.weight * moves[d];
      }
    }
    located_ = true;
    if (sum <= 0.0) return;  // over
    for (int i = 0; i < kStates; ++i) probability_[i] = updated[i] / sum;
  }

 private:
  static constexpr int kStates = TagFloor::kCells * TagFloor::kCells;

  Tag::State stateAt(int i) const {
    return {static_cast<std::int8_t>(i / TagFloor::kCells),
            static_cast<std::int8_t>(i % TagFloor::kCells), located_};
  }

  std::array<double, kStates> probability_{};
  bool located_ = false;
};

}  // namespace pomdp_crowd_nav
