// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <vector>

#include "pomdp_crowd_nav/despot/expansion.h"
#include "pomdp_crowd_nav/despot/noise_streams.h"

namespace pomdp_crowd_nav {

// The tiger problem (Kaelbling, Littman, Cassandra 1998): a tiger is behind one of two doors,
// listening tells which with some error, and opening a door ends it. Each scenario has a state of
// its own. The default policy listens until the horizon.
class Tiger {
 public:
  enum State { kTigerLeft, kTigerRight };
  enum Action { kListen, kOpenLeft, kOpenRight };
  static constexpr bool kSharesState = false;

  static constexpr double kHearsRight = 0.85;  // probability that listening tells the truth
  static constexpr float kListening = -1.0F;
  static constexpr float kTreasure = 10.0F;
  static constexpr float kMauled = -100.0F;

  struct Params {
    double discount = 0.95;
    int horizon = 5;
    std::uint64_t seed = 1;
  };

  explicit Tiger(const Params& params) : params_(params), noise_(params.seed) {}

  void actions(const State&, std::vector<Action>& out) const {
    out = {kListen, kOpenLeft, kOpenRight};
  }

  Branch step(const State& state, int scenario, int depth, const Action& action,
              State& next) const {
    next = state;
    Branch branch;
    branch.terminal = action != kListen;
    if (branch.terminal) {
      branch.reward = (action == kOpenLeft) == (state == kTigerLeft) ? kMauled : kTreasure;
      return branch;
    }
    branch.reward = kListening;
    const bool truth = noise_.uniform(scenario, depth + 1, 0) < kHearsRight;
    branch.observation = truth == (state == kTigerLeft) ? 0 : 1;  // 0: heard on the left
    return branch;
  }

  void bound(const State&, int, int depth, Branch& branch) const {
    branch.lower[0] = listeningFrom(depth);
    branch.upper = depth < params_.horizon ? kTreasure : branch.lower[0];
  }

  void expand(const State* states, const int* scenarios, int count, int depth,
              Expansion<Tiger>& out) const {
    expandOneByOne(*this, states, scenarios, count, depth, out);
  }

  void rootBounds(const State*, const int*, int, double& lower, double& upper) const {
    lower = listeningFrom(0);
    upper = kTreasure;
  }

  Action defaultAction(const State*) const { return kListen; }

 private:
  float listeningFrom(int depth) const {
    double value = 0.0;
    for (int d = params_.horizon; d > depth; --d) value = kListening + params_.discount * value;
    return static_cast<float>(value);
  }

  Params params_;
  NoiseStreams noise_;
};

}  // namespace pomdp_crowd_nav
