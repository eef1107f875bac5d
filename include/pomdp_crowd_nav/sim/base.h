// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pomdp_crowd_nav/world/base_command.h"
#include "pomdp_crowd_nav/world/vehicle.h"

namespace pomdp_crowd_nav {

// A simulated omnidirectional base that follows commands within the limits of its VehicleParams.
class SimulatedBase {
 public:
  SimulatedBase(const VehicleParams& params, const Pose& start);

  // Follows `command` for `duration` seconds: an instant base takes its velocity at once, the other
  // changes each axis of its velocity by at most acceleration (brake_deceleration when slowing)
  // * duration. Speed and yaw rate never exceed their maxima. Non-finite commands count as zero.
  void follow(const BaseCommand& command, double duration);

  void place(const Pose& pose);  // at rest

  const Pose& pose() const { return pose_; }                // heading: of the body
  const Point& velocity() const { return velocity_; }       // [m/s], planning frame
  double yawRate() const { return yaw_rate_; }               // [rad/s]

 private:
  VehicleParams params_;
  Pose pose_;
  Point velocity_{0.0, 0.0};
  double yaw_rate_ = 0.0;
};

}  // namespace pomdp_crowd_nav
