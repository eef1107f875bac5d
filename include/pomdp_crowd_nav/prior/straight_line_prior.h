// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pomdp_crowd_nav/prior/rollout_prior.h"

namespace pomdp_crowd_nav {

// Straight to the goal, whatever stands in the way.
class StraightLinePrior : public RolloutPrior {
 public:
  explicit StraightLinePrior(const Point& goal) : goal_(goal) {}

  const Point& goal() const override { return goal_; }
  std::optional<double> directionAt(const Pose& pose) const override;
  double distanceToGoal(const Point& position) const override;
  bool isStraightLine() const override { return true; }

 private:
  Point goal_;
};

}  // namespace pomdp_crowd_nav
