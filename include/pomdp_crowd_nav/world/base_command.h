// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pomdp_crowd_nav/world/geometry.h"

namespace pomdp_crowd_nav {

// Velocity command in the base frame (REP-103), as in geometry_msgs/Twist.
struct BaseCommand {
  Point velocity{0.0, 0.0};  // [m/s], x forward, y left
  double yaw_rate = 0.0;     // [rad/s]
};

}  // namespace pomdp_crowd_nav
