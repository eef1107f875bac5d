// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>

#include <functional>

#include "pomdp_crowd_nav/ros/drive.h"
#include "pomdp_crowd_nav/ros/guarded.h"
#include "pomdp_crowd_nav/ros/message_gate.h"

namespace pomdp_crowd_nav {

// What no base can report of itself.
struct ReadingRange {
  double position = 1.0e6;  // [m], of either coordinate
  double speed = 10.0;      // [m/s]
  double yaw_rate = 10.0;   // [rad/s]
};

// Several times what the vehicle can do.
ReadingRange readingRange(const VehicleParams& vehicle);

bool isWithin(const RobotReading& reading, const ReadingRange& range);

// The topic `odom`: the newest reading in the global frame. Refuses what makes no sense.
class OdometryInput {
 public:
  // `on_jump` is called when the robot is suddenly elsewhere, before that reading is used.
  OdometryInput(ros::NodeHandle& node, const VehicleParams& vehicle, const MessageGate& gate,
                Guarded<Drive>& drive, std::function<void()> on_jump);

 private:
  void onOdometry(const nav_msgs::Odometry& odometry);
  void take(const RobotReading& reading, const HeaderVerdict& verdict);
  void refuse(MessageFault fault);

  VehicleParams vehicle_;
  ReadingRange range_;
  const MessageGate& gate_;
  Guarded<Drive>& drive_;
  std::function<void()> on_jump_;
  NewestStamp newest_;  // callbacks of one topic do not overlap
  ros::Subscriber subscriber_;
};

}  // namespace pomdp_crowd_nav
