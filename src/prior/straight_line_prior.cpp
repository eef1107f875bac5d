// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/prior/straight_line_prior.h"

namespace pomdp_crowd_nav {

std::optional<double> StraightLinePrior::directionAt(const Pose& pose) const {
  return bearing(pose.position, goal_);
}

double StraightLinePrior::distanceToGoal(const Point& position) const {
  return (goal_ - position).norm();
}

}  // namespace pomdp_crowd_nav
