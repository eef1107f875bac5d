// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "pomdp_crowd_nav/world/static_map.h"
#include "pomdp_crowd_nav/world/vehicle.h"

namespace pomdp_crowd_nav {

// Keeps a robot that follows a plan for another map from driving into what the newest map shows.
// A robot that touches an obstacle already, as the map has it, may drive away from it, and one that
// is inside may drive out.
class ObstacleReflex {
 public:
  // `reaction_time` [s] until a command to brake takes effect.
  ObstacleReflex(const VehicleParams& vehicle, double reaction_time)
      : vehicle_(vehicle), reaction_time_(reaction_time) {}

  // Whether the robot touches an obstacle on its way to rest, unless it brakes now or earlier.
  bool mustBrake(const VehicleState& state, const StaticMap& map) const;

  // Whether it does on the motion, or on its way to rest from the end of it.
  bool hits(const StepMotion& motion, const StaticMap& map) const;

 private:
  bool touches(const std::vector<Point>& way, const StaticMap& map) const;
  bool leadsOut(const std::vector<Point>& way, const StaticMap& map) const;
  void addBraking(const VehicleState& from, std::vector<Point>& way) const;

  VehicleParams vehicle_;
  double reaction_time_;
};

}  // namespace pomdp_crowd_nav
