// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "pomdp_crowd_nav/world/vehicle.h"

namespace pomdp_crowd_nav {

// The vehicle as the search stores it: one per belief node, the direction of travel as a unit
// vector so that no step needs a sine. Float holds a field of 1 km to 0.1 mm.
struct RobotState {
  float x = 0.0F;  // [m]
  float y = 0.0F;
  float direction_x = 1.0F;
  float direction_y = 0.0F;
  float speed = 0.0F;  // [m/s]

  static RobotState from(const VehicleState& vehicle) {
    return {static_cast<float>(vehicle.position.x()), static_cast<float>(vehicle.position.y()),
            static_cast<float>(std::cos(vehicle.heading)),
            static_cast<float>(std::sin(vehicle.heading)), static_cast<float>(vehicle.speed)};
  }

  VehicleState vehicle() const {
    return {Point(x, y), std::atan2(direction_y, direction_x), speed};
  }
};

}  // namespace pomdp_crowd_nav
