// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <visualization_msgs/MarkerArray.h>

#include <string>

#include "pomdp_crowd_nav/ros/messages.h"
#include "pomdp_crowd_nav/ros/trail.h"
#include "pomdp_crowd_nav/world/geometry.h"

namespace pomdp_crowd_nav {

struct RobotScene {
  const Trail& trail;
  const PlannerStatus& status;
  std::string base_frame;           // with which disc and distance move
  Point robot{0.0, 0.0};            // [m]
  Point headline{0.0, 0.0};         // [m], where the status is written
  double radius = 1.0;              // [m]
  double emergency_distance = 0.0;  // [m], from the robot's centre; 0: none
  double symbol_size = 0.5;         // [m], see markers.h
  double letter_size = 1.0;         // [m]
};

// The robot's disc, the distance at which it is stopped, where it has driven, older places paler,
// and in words what it does; beside it, why it does not drive. As markers.h says of all arrays.
visualization_msgs::MarkerArray robotMarkers(const RobotScene& scene,
                                             const std_msgs::Header& header);

// Two lines: state and cause; the last decision.
std::string statusText(const PlannerStatus& status);

}  // namespace pomdp_crowd_nav
