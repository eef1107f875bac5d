// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace pomdp_crowd_nav {

// One choice of the planner: a change of heading (delta_theta) and of speed (delta_s). Small, for
// the search tree holds one for each of its nodes.
struct Action {
  // kFollowPrior: delta_RO, along the prior's path.
  enum class Heading : std::uint8_t { kTurn, kFollowPrior };

  float turn = 0.0F;  // [rad], for kTurn
  Heading heading = Heading::kTurn;
  std::int8_t speed_steps = 0;  // -1, 0 or 1 times the speed step
  bool sudden_brake = false;    // SB: stop as fast as the base can

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
using ActionFloats = float[kMaxActions];
using ActionFlags = int[kMaxActions];  // -1 true, 0 false

// Actions in the order in which ties are broken, and what a step multiplies with: index a is
// action a; the last is repeated to the end of the arrays.
struct ActionSet {
  explicit ActionSet(std::vector<Action> some);

  std::vector<Action> actions;
  alignas(64) ActionFloats turn_cos, turn_sin, speed_steps;
  alignas(64) ActionFlags follows_prior, brakes;
};

// The paper's sets (section ES planner): 9 actions at rest, 11 when moving; delta_RO is left out
// where the prior knows no way.
class ActionSets {
 public:
  ActionSets();

  const ActionSet& legal(bool moving, bool has_way) const {
    return sets_[(moving ? 2 : 0) + (has_way ? 1 : 0)];
  }

 private:
  std::vector<ActionSet> sets_;
};

}  // namespace pomdp_crowd_nav
