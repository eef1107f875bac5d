// SPDX-License-Identifier: BSD-3-Clause
// The example of doc/solver.md, which shows the lines between the two marks.
#pragma once

#include <cmath>
#include <vector>

#include "pomdp_crowd_nav/despot/search.h"

namespace pomdp_crowd_nav {

// [begin of the example]
// A robot walks along cells 0 to 3; cell 2 is a road. Cars come and go whatever the robot does, and
// it sees whether one is passing only once the step is over.
class Crossing {
 public:
  using State = int;  // the robot's cell, the same in all scenarios of a belief
  enum Action { kWait, kGo };
  static constexpr bool kSharesState = true;
  static constexpr int kRoad = 2;
  static constexpr int kFarSide = 3;
  static constexpr int kHorizon = 12;  // steps
  static constexpr float kGamma = 0.95F;

  explicit Crossing(std::uint64_t seed) : noise_(seed) {}

  // What takes its course: called once per search. A car stays or comes with these odds.
  void drawExogenous(int scenarios, int depth) {
    const auto is_car = [](double odds, int scenario, int d, const NoiseStreams& noise) {
      return static_cast<char>(noise.uniform(scenario, d, 0) < odds);
    };
    cars_.draw(
        scenarios, depth, noise_,
        [&](int k, const NoiseStreams& noise) { return is_car(0.5, k, 0, noise); },
        [&](char before, int k, int d, const NoiseStreams& noise) {
          return is_car(before != 0 ? 0.7 : 0.1, k, d, noise);
        });
  }

  void actions(const State&, std::vector<Action>& out) const { out = {kWait, kGo}; }

  // G: next state, reward and observation; entering the road before a car ends it all.
  Branch step(const State& cell, int scenario, int depth, Action action, State& next) const {
    next = action == kGo ? cell + 1 : cell;
    const bool car = cars_.at(scenario, depth + 1) != 0;
    const bool is_hit = next == kRoad && car;
    Branch branch;
    branch.reward = -1.0F + (is_hit ? -50.0F : 0.0F) + (next == kFarSide ? 20.0F : 0.0F);
    branch.terminal = is_hit || next == kFarSide;
    branch.observation = car ? 1 : 0;
    return branch;
  }

  // Bounds on what can still be earned: wait to the end, and walk on with no car about.
  void bound(const State& cell, int, int depth, Branch& branch) const {
    branch.lower[0] =
        -(1.0F - std::pow(kGamma, static_cast<float>(kHorizon - depth))) / (1.0F - kGamma);
    branch.upper = depth < kHorizon ? 19.0F * std::pow(kGamma, static_cast<float>(2 - cell)) : 0.0F;
  }

  // What the search asks for: an expansion, here one scenario at a time; bounds of the root; an
  // action in case that there is no time at all.
  void expand(const State* states, const int* scenarios, int count, int depth,
              Expansion<Crossing>& out) const {
    expandOneByOne(*this, states, scenarios, count, depth, out);
  }
  void rootBounds(const State* states, const int* scenarios, int count, double& lower,
                  double& upper) const {
    boundOneByOne(*this, states, scenarios, count, lower, upper);
  }
  Action defaultAction(const State*) const { return kWait; }

 private:
  NoiseStreams noise_;
  ExogenousTable<char> cars_;
};

inline SearchResult<Crossing::Action> cross(int cell, std::uint64_t seed) {
  SearchParams params;
  params.scenarios = 500;
  params.max_depth = Crossing::kHorizon;
  params.discount = Crossing::kGamma;
  Crossing model(seed);
  Search<Crossing> search(params);
  return search.run(model, {cell}, SearchLimit::trials(1000));
}
// [end of the example]

}  // namespace pomdp_crowd_nav
