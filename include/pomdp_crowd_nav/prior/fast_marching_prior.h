// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pomdp_crowd_nav/prior/arrival_time_field.h"
#include "pomdp_crowd_nav/prior/clearance_grid.h"
#include "pomdp_crowd_nav/prior/descent_directions.h"
#include "pomdp_crowd_nav/prior/prior_factory.h"
#include "pomdp_crowd_nav/prior/rollout_prior.h"

namespace pomdp_crowd_nav {

// Speed of the front over a map: 1 outside the clearance, `narrow_speed` inside it where the robot
// has room, `blocked_speed` where it has none, and a tenth of that in cells that an obstacle may
// touch, so that no wall is too thin to be seen and the way out of an obstacle is a short one.
// Throws std::invalid_argument naming the first parameter that is out of range.
SpeedMap makeSpeedMap(const StaticMap& map, const PriorParams& params);
SpeedMap makeSpeedMap(const ClearanceGrid& clearances, const PriorParams& params);

// Shortest paths by Fast Marching: down the gradient of the time at which a front that starts at
// the goal arrives (paper, section on Fast Marching). Knows every place of the grid that covers
// the map; the last few cells before the goal are driven straight.
class FastMarchingPrior : public RolloutPrior {
 public:
  // Throws std::invalid_argument on parameters out of range or a goal off the map.
  FastMarchingPrior(const StaticMap& map, const Point& goal, const PriorParams& params);

  // For a new goal on the same map. Throws std::invalid_argument as ArrivalTimeField does.
  FastMarchingPrior(const SpeedMap& speed_map, const Point& goal);

  const Point& goal() const override { return field_.source(); }
  std::optional<double> directionAt(const Pose& pose) const override;

  // True length, also where the path leaves a slow area: not the arrival time.
  double distanceToGoal(const Point& position) const override;

  Course courseAt(const Pose& pose) const override;

  const ArrivalTimeField& field() const { return field_; }

 private:
  bool isNearGoal(double path_length) const;
  Point descentAt(const Point& position) const;

  ArrivalTimeField field_;
  Directions directions_;
};

}  // namespace pomdp_crowd_nav
