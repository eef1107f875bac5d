// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "pomdp_crowd_nav/pomdp/model_params.h"
#include "pomdp_crowd_nav/pomdp/robot_state.h"

namespace pomdp_crowd_nav {

// No policy earns more than this from a state, whatever people do.
//
// Arriving takes at least n steps: the shortest way to within the goal tolerance is the straight
// line, and no step is longer than one at the speed that full acceleration has reached by then.
// The goal's reward is paid in the step after arrival (facts sheet, section 11 no. 18), hence
//   kPaper: gamma^n R_goal
//   kTight: the same, less R_t and R_speed of those n + 1 steps. R_speed falls with speed and no
//           policy is faster than full acceleration, so none that arrives pays less. One that does
//           not arrive earns nothing, hence the bound is at least 0.
class UpperBound {
 public:
  UpperBound(const ModelParams& params, const Point& goal);

  float value(const RobotState& state) const;

 private:
  float tightValue(const RobotState& state, float distance) const;

  UpperBoundKind kind_;
  Point goal_;
  float goal_tolerance_, max_speed_, speed_step_, step_, goal_reward_;
  float time_cost_, low_speed_cost_, discount_;
  bool instant_;
  std::vector<float> discounts_;   // gamma^n
  std::vector<float> full_speed_;  // value of n steps at full speed and then the goal's reward
};

}  // namespace pomdp_crowd_nav
