// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <vector>

#include "pomdp_crowd_nav/despot/expansion.h"
#include "pomdp_crowd_nav/despot/noise_streams.h"

namespace pomdp_crowd_nav {

// A walk along a few cells to a goal at the end, all scenarios in one place. In every scenario a
// puddle lies in some cell at each depth; it is seen once the step is over, and moves on by at
// most one cell, so that it pays to wait. Two default policies: stand still and walk on.
class Corridor {
 public:
  struct State {
    int cell = 0;
  };
  enum Action { kStay, kForward, kBack };
  static constexpr bool kSharesState = true;

  static constexpr int kGoal = 3;  // [cells]
  static constexpr float kWaiting = -1.0F;
  static constexpr float kPuddle = -7.0F;
  static constexpr float kArrival = 20.0F;

  struct Params {
    double discount = 0.9;
    int horizon = 5;
    bool has_second_policy = true;
    float upper = kArrival;          // what the leaves claim as their bound
    float looser_by = 0.0F;          // more that they claim for each step of depth
    bool pays_after_arrival = true;  // the reward comes with the step after arrival, and ends it
    std::uint64_t seed = 1;
  };

  explicit Corridor(const Params& params) : params_(params), noise_(params.seed) {}

  void actions(const State& state, std::vector<Action>& out) const {
    out = {kStay, kForward};
    if (state.cell > 0) out.push_back(kBack);
  }

  Branch step(const State& state, int scenario, int depth, const Action& action,
              State& next) const {
    const int change = action == kForward ? 1 : (action == kBack ? -1 : 0);
    next.cell = std::clamp(state.cell + change, 0, kGoal);
    Branch branch;
    branch.reward = kWaiting;
    branch.observation = static_cast<std::uint64_t>(puddle(scenario, depth + 1));
    branch.terminal = (params_.pays_after_arrival ? state.cell : next.cell) == kGoal;
    if (branch.terminal) {
      branch.reward += kArrival;
    } else if (next.cell == puddle(scenario, depth + 1)) {
      branch.reward += kPuddle;
    }
    return branch;
  }

  void bound(const State& state, int scenario, int depth, Branch& branch) const {
    branch.lower[0] = rollOut(state, scenario, depth, kStay);
    if (params_.has_second_policy) branch.lower[1] = rollOut(state, scenario, depth, kForward);
    branch.upper = depth < params_.horizon
                       ? params_.upper + params_.looser_by * static_cast<float>(depth)
                       : 0.0F;
  }

  void expand(const State* states, const int* scenarios, int count, int depth,
              Expansion<Corridor>& out) const {
    expandOneByOne(*this, states, scenarios, count, depth, out);
  }

  void rootBounds(const State* states, const int* scenarios, int count, double& lower,
                  double& upper) const {
    double stays = 0.0;
    double walks = 0.0;
    for (int i = 0; i < count; ++i) {
      stays += rollOut(states[0], scenarios[i], 0, kStay) / count;
      walks += rollOut(states[0], scenarios[i], 0, kForward) / count;
    }
    lower = params_.has_second_policy ? std::max(stays, walks) : stays;
    upper = params_.upper;
  }

  Action defaultAction(const State*) const { return kStay; }

 private:
  int puddle(int scenario, int depth) const {
    int cell = 1 + static_cast<int>(2.0 * noise_.uniform(scenario, 0, 0));
    for (int d = 1; d <= depth; ++d) {
      cell += static_cast<int>(3.0 * noise_.uniform(scenario, d, 0)) - 1;
      cell = std::clamp(cell, 0, kGoal);
    }
    return cell;
  }

  // Nothing beyond the horizon.
  float rollOut(State state, int scenario, int depth, Action action) const {
    float value = 0.0F;
    float discount = 1.0F;
    for (; depth < params_.horizon; ++depth) {
      State next;
      const Branch branch = step(state, scenario, depth, action, next);
      value += discount * branch.reward;
      if (branch.terminal) break;
      discount *= static_cast<float>(params_.discount);
      state = next;
    }
    return value;
  }

  Params params_;
  NoiseStreams noise_;
};

}  // namespace pomdp_crowd_nav
