// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "pomdp_crowd_nav/ros/map_input.h"
#include "pomdp_crowd_nav/ros/odometry_input.h"
#include "pomdp_crowd_nav/ros/people_input.h"

namespace pomdp_crowd_nav {

// Brings odometry, tracked people and the map into the global frame and into the shared state.
//
// A message that makes no sense is refused and counted, by what is wrong with it: its input then
// ages, and the robot stops when it is too old. When ROS time jumps or the robot is suddenly
// elsewhere, everything known of people is forgotten and the base is braked; it is braked too while
// ROS time stands still.
class InputListener {
 public:
  InputListener(ros::NodeHandle& node, const PlannerNodeParams& params, Guarded<Drive>& drive);

  // Pose of `frame` in the global frame at `stamp`, waiting for it a little; else the newest one if
  // it is not older than the tolerance. None for a frame that is not known.
  std::optional<Pose> frameAt(const std::string& frame, const ros::Time& stamp);

  const std::vector<Point>& destinations() const { return people_.destinations(); }

 private:
  void watchClock();
  void onClockJump();
  void startAfresh(StopCause jump);

  Guarded<Drive>& drive_;
  FrameSource frames_;
  ClockWatch clock_;
  MessageGate gate_;
  PeopleInput people_;
  OdometryInput odometry_;
  MapInput map_;
  ros::SteadyTimer clock_timer_;
};

}  // namespace pomdp_crowd_nav
