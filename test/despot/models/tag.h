// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "defaults.h"
#include "pomdp_crowd_nav/despot/expansion.h"
#include "pomdp_crowd_nav/despot/noise_streams.h"
#include "tag_values.h"

namespace pomdp_crowd_nav {

// Tag (Pineau, Gordon, Thrun 2003): find an opponent that runs away and is seen from its own cell
// only. Both start anywhere; the robot does not know where it is before its first observation.
//
// Leaves are valued by expectations over all that may come after them, not by the scenario's own
// noise: the mean over scenarios is the same, with less scatter. The default policies know the
// robot's cell and whether the opponent is seen, which are the same in all scenarios of a belief.
// They tag on sight and walk round the floor one way or the other until then (plain: run into a
// wall).
class Tag {
 public:
  struct State {
    std::int8_t robot = 0;     // cell
    std::int8_t opponent = 0;  // cell
    bool located = false;      // an observation has told the robot's cell, or that it may tag
  };
  enum Action { kNorth, kEast, kSouth, kWest, kTag };
  static constexpr bool kSharesState = false;
  static constexpr std::uint64_t kSeen = TagFloor::kCells;  // else the observation is the cell

  Tag(const TagValues& values, std::uint64_t seed, Defaults defaults = Defaults::kSmart)
      : values_(values), defaults_(defaults), noise_(seed) {}

  void actions(const State&, std::vector<Action>& out) const {
    out = {kNorth, kEast, kSouth, kWest, kTag};
  }

  Branch step(const State& state, int scenario, int depth, Action action, State& next) const {
    Branch branch;
    next = state;
    if (action == kTag) {
      branch.terminal = state.robot == state.opponent;
      branch.reward = branch.terminal ? TagValues::kTagged : TagValues::kMissed;
      if (branch.terminal) return branch;
    } else {
      branch.reward = TagValues::kMoving;
      next.robot = static_cast<std::int8_t>(TagFloor::moved(state.robot, action));
    }
    next.opponent = opponentAfter(state, noise_.uniform(scenario, depth, 0));
    next.located = true;
    branch.observation = observationOf(next);
    return branch;
  }

  void bound(const State& state, int, int, Branch& branch) const {
    branch.upper = static_cast<float>(values_.chase(state.robot, state.opponent));
    for (int p = 0; p < kDefaultPolicies; ++p) {
      branch.lower[p] = static_cast<float>(defaultValue(p, state));
    }
  }

  void expand(const State* states, const int* scenarios, int count, int depth,
              Expansion<Tag>& out) const {
    expandOneByOne(*this, states, scenarios, count, depth, out);
  }

  void rootBounds(const State* states, const int* scenarios, int count, double& lower,
                  double& upper) const {
    boundOneByOne(*this, states, scenarios, count, lower, upper);
  }

  Action defaultAction(const State* states) const {
    if (!states[0].located) return kNorth;
    if (states[0].robot == states[0].opponent) return kTag;
    return static_cast<Action>(TagValues::directionOf(0, states[0].robot));
  }

  static std::uint64_t observationOf(const State& state) {
    return state.robot == state.opponent ? kSeen : static_cast<std::uint64_t>(state.robot);
  }

 private:
  double defaultValue(int policy, const State& state) const {
    if (!state.located) return values_.never();
    if (state.robot == state.opponent) return TagValues::kTagged;
    if (defaults_ == Defaults::kPlain || policy >= TagValues::kRounds) return values_.never();
    return values_.round(policy, state.robot, state.opponent);
  }

  std::int8_t opponentAfter(const State& state, double luck) const {
    const auto& probability = values_.moves(state.robot, state.opponent);
    int direction = 0;
    while (direction < TagFloor::kStay && luck >= probability[direction]) {
      luck -= probability[direction++];
    }
    return static_cast<std::int8_t>(TagFloor::moved(state.opponent, direction));
  }

  const TagValues& values_;
  Defaults defaults_;
  NoiseStreams noise_;
};

}  // namespace pomdp_crowd_nav
