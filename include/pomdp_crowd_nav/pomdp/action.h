// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace pomdp_crowd_nav {

// One choice of the planner: a change of heading (delta_theta) and of speed (delta_s).
struct Action {
  enum class Heading { kTurn, kFollowPrior };  // kFollowPrior: delta_RO, along the prior's path

  Heading heading = Heading::kTurn;
  float turn = 0.0F;  // [rad], for kTurn
  float turn_cos = 1.0F;
  float turn_sin = 0.0F;
  int speed_steps = 0;        // -1, 0 or 1 times the speed step
  bool sudden_brake = false;  // SB: stop as fast as the base can

  static Action turnBy(double angle, int speed_steps);
  static Action followPrior(int speed_steps);
  static Action suddenBrake();

  bool operator==(const Action& other) const;
  bool operator!=(const Action& other) const { return !(*this == other); }
};

// "turn +15 deg, speed +1", for messages.
std::string describe(const Action& action);

// Most actions that a set holds: the search's kernels work on this many at once.
constexpr int kMaxActions = 16;

// The paper's sets (section ES planner), in the order in which ties are broken: 9 actions at
// rest, 11 when moving; delta_RO is left out where the prior knows no way.
class ActionSets {
 public:
  ActionSets();

  const std::vector<Action>& legal(bool moving, bool has_way) const {
    return sets_[(moving ? 2 : 0) + (has_way ? 1 : 0)];
  }

 private:
  std::vector<Action> sets_[4];
};

}  // namespace pomdp_crowd_nav
