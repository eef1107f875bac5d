// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "pomdp_crowd_nav/pomdp/model_params.h"
#include "pomdp_crowd_nav/pomdp/robot_state.h"
#include "pomdp_crowd_nav/prior/clearance_grid.h"
#include "pomdp_crowd_nav/prior/shortest_way.h"

namespace pomdp_crowd_nav {

// No policy earns more than this from a state, whatever people do.
//
// Arriving takes at least n steps: no way to within the goal tolerance is shorter than the straight
// line, and no step is longer than one at the speed that full acceleration has reached by then.
// The goal's reward is paid in the step after arrival (facts sheet, section 11 no. 18), hence
//   kPaper: gamma^n R_goal
//   kTight: the same, less R_t and R_speed of those n + 1 steps. R_speed falls with speed and no
//           policy is faster than full acceleration, so none that arrives pays less. One that does
//           not arrive earns nothing, hence the bound is at least 0. Given a table of shortest
//           ways round the obstacles, n counts the longer of its way and the straight line.
class UpperBound {
 public:
  // `shortest_way`, if any, must outlive the bound.
  UpperBound(const ModelParams& params, const Point& goal,
             const ShortestWay* shortest_way = nullptr);

  // `way_to_goal` [m]: of a robot that drives at least so far to the goal's centre.
  float value(const RobotState& state, float way_to_goal = 0.0F) const;

 private:
  float tightValue(float speed, float distance) const;

  UpperBoundKind kind_;
  Point goal_;
  const ShortestWay* shortest_way_;
  float goal_tolerance_, max_speed_, speed_step_, step_, goal_reward_;
  float time_cost_, low_speed_cost_, discount_;
  bool instant_;
  std::vector<float> discounts_;   // gamma^n
  std::vector<float> full_speed_;  // value of n steps at full speed and then the goal's reward
};

// The table that makes the bound of this model tighter on this map, for this goal. Nothing
// where straight lines are all the bound knows: kPaper, or no obstacles.
std::optional<ShortestWay> makeShortestWay(const ModelParams& params, const ClearanceGrid& map,
                                           const Point& goal);

}  // namespace pomdp_crowd_nav
