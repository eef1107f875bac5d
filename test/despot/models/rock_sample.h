// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

#include "defaults.h"
#include "pomdp_crowd_nav/despot/expansion.h"
#include "pomdp_crowd_nav/despot/noise_streams.h"
#include "rock_sample_inspection.h"
#include "rock_sample_plans.h"

namespace pomdp_crowd_nav {

// What does not change between searches.
struct RockSampleTables {
  explicit RockSampleTables(const RockSampleMap& map) : plans(map), inspection(map) {}
  RockSamplePlans plans;
  RockSampleInspection inspection;
};

// RockSample (Smith and Simmons 2004): fetch the good rocks, which a sensor tells from the bad ones
// the better the nearer they are, and leave by the east.
//
// A scenario's state holds which rocks are good, which only noise and rewards may look at, and what
// the history says of them, which is the same in all scenarios of a belief. The default policies
// are chosen by the history alone: a policy that acted on `good` would act differently in scenarios
// that cannot be told apart, and its value would be no lower bound. They are: fetch the rocks that
// the history speaks for without another check, and inspect those that it does not speak against
// (plain: leave straight away).
class RockSample {
 public:
  struct State {
    std::uint8_t cell = 0;
    std::uint8_t good = 0;  // bit r: rock r is good, and not yet sampled
    // Of each rock, given the history: log of the odds that it is good [kEvidenceUnit].
    std::array<std::int8_t, RockSampleMap::kMostRocks> log_odds = {};
  };
  using Action = int;  // RockSampleAction
  enum Observation : std::uint64_t { kNothing, kLooksGood, kLooksBad };
  static constexpr bool kSharesState = false;
  static constexpr float kIllegal = -100.0F;
  static constexpr double kEvidenceUnit = 1.0 / 8.0;
  static constexpr int kDismissed = -1;         // such a rock is not inspected
  static constexpr std::int8_t kCertain = 100;  // more evidence than any there is

  RockSample(const RockSampleTables& tables, std::uint64_t seed,
             Defaults defaults = Defaults::kSmart)
      : tables_(tables), defaults_(defaults), noise_(seed) {
    for (int i = 0; i < map().cellCount() * map().rockCount(); ++i) {
      const double truth = map().accuracy(i / map().rockCount(), i % map().rockCount());
      const double evidence = std::log(truth / (1.0 - truth)) / kEvidenceUnit;
      checks_.push_back({truth, static_cast<int>(std::min<double>(evidence, kCertain))});
    }
    for (int cell = 0; cell < map().cellCount(); ++cell) rock_at_.push_back(map().rockAt(cell));
  }

  const RockSampleMap& map() const { return tables_.plans.map(); }

  // A move off the map or a sample of bare ground costs 100 and does nothing: they are left out.
  void actions(const State& state, std::vector<Action>& out) const {
    out.clear();
    for (int move = RockSampleAction::kNorth; move <= RockSampleAction::kWest; ++move) {
      if (map().moved(state.cell, move) != state.cell) out.push_back(move);
    }
    if (rock_at_[state.cell] >= 0) out.push_back(RockSampleAction::kSample);
    for (int r = 0; r < map().rockCount(); ++r) out.push_back(RockSampleAction::kCheck + r);
  }

  Branch step(const State& state, int scenario, int depth, Action action, State& next) const {
    Branch branch;
    next = state;
    if (action < RockSampleAction::kSample) {
      move(action, next, branch);
    } else if (action == RockSampleAction::kSample) {
      sample(next, branch);
    } else {
      const int rock = action - RockSampleAction::kCheck;
      branch.observation = check(rock, noise_.uniform(scenario, depth, 0), next);
    }
    return branch;
  }

  // Above: what is to be had by one who knows the rocks.
  void bound(const State& state, int, int, Branch& branch) const {
    const int likely = rocksAbove(0, state);
    const int open = rocksAbove(kDismissed, state);
    branch.lower[0] = tables_.plans.valueIf(state.cell, likely, state.good);
    branch.lower[1] = defaults_ == Defaults::kSmart
                          ? tables_.inspection.value(state.cell, open, state.good)
                          : tables_.plans.valueIf(state.cell, 0, state.good);
    branch.upper = tables_.plans.value(state.cell, state.good);
  }

  void expand(const State* states, const int* scenarios, int count, int depth,
              Expansion<RockSample>& out) const {
    expandOneByOne(*this, states, scenarios, count, depth, out);
  }

  void rootBounds(const State* states, const int* scenarios, int count, double& lower,
                  double& upper) const {
    boundOneByOne(*this, states, scenarios, count, lower, upper);
  }

  Action defaultAction(const State* states) const {
    return tables_.plans.action(states[0].cell, rocksAbove(0, states[0]));
  }

 private:
  struct Check {
    double accuracy = 0.5;
    int evidence = 0;  // [kEvidenceUnit]
  };

  void move(Action action, State& state, Branch& branch) const {
    const int to = map().moved(state.cell, action);
    branch.terminal = to < 0;
    branch.reward = to < 0 ? RockSamplePlans::kExit : (to == state.cell ? kIllegal : 0.0F);
    if (to >= 0) state.cell = static_cast<std::uint8_t>(to);
  }

  void sample(State& state, Branch& branch) const {
    const int rock = rock_at_[state.cell];
    branch.reward = kIllegal;
    if (rock < 0) return;
    branch.reward = isGood(state, rock) ? RockSamplePlans::kRock : -RockSamplePlans::kRock;
    state.good = static_cast<std::uint8_t>(state.good & ~(1 << rock));
    state.log_odds[rock] = -kCertain;
  }

  Observation check(int rock, double luck, State& state) const {
    const Check& sensor = checks_[state.cell * map().rockCount() + rock];
    const bool looks_good = (luck < sensor.accuracy) == isGood(state, rock);
    if (std::abs(state.log_odds[rock]) < kCertain) {
      const int sum = state.log_odds[rock] + (looks_good ? sensor.evidence : -sensor.evidence);
      state.log_odds[rock] = static_cast<std::int8_t>(std::clamp<int>(sum, -kCertain, kCertain));
    }
    return looks_good ? kLooksGood : kLooksBad;
  }

  static bool isGood(const State& state, int rock) { return (state.good >> rock & 1) != 0; }

  // The rocks for which the history speaks more than so much.
  int rocksAbove(int log_odds, const State& state) const {
    int rocks = 0;
    for (int r = 0; r < map().rockCount(); ++r) {
      rocks |= (state.log_odds[r] > log_odds) << r;
    }
    return rocks;
  }

  const RockSampleTables& tables_;
  Defaults defaults_;
  NoiseStreams noise_;
  std::vector<Check> checks_;  // cell by cell
  std::vector<int> rock_at_;   // -1: none
};

}  // namespace pomdp_crowd_nav
