// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

#include "pomdp_crowd_nav/world/base_command.h"
#include "pomdp_crowd_nav/world/vehicle.h"

namespace pomdp_crowd_nav {

// A simulated base, omnidirectional or a car, that follows commands within the limits of its
// VehicleParams.
class SimulatedBase {
 public:
  SimulatedBase(const VehicleParams& params, const Pose& start);

  // Follows `command` for `duration` seconds: an instant base takes its velocity at once, the other
  // changes x by at most acceleration * duration, y by lateral_acceleration * duration, and either
  // by brake_deceleration * duration when slowing. The commanded velocity keeps its direction in
  // the planning frame during the call, while the body turns. Speed and yaw rate never exceed their
  // maxima. Non-finite commands count as zero.
  //
  // A car follows the forward speed and the curvature of the command, on one arc; it goes neither
  // sideways nor backwards, nor on a tighter curve than its steering allows. It keeps its curvature
  // when it is told to stop.
  void follow(const BaseCommand& command, double duration);

  void place(const Pose& pose);  // at rest

  const Pose& pose() const { return pose_; }           // heading: of the body
  const Point& velocity() const { return velocity_; }  // [m/s], planning frame
  double yawRate() const { return yaw_rate_; }         // [rad/s]

 private:
  void followCar(double speed, double yaw_rate, double duration);
  void driveArc(double speed_after, double duration);
  void ramp(const Eigen::Rotation2Dd& body, const Point& target, double yaw_target,
            double duration);
  void move(const Point& mean_velocity, double mean_yaw_rate, double duration);

  VehicleParams params_;
  Pose pose_;
  Point velocity_{0.0, 0.0};
  double yaw_rate_ = 0.0;
  double curvature_ = 0.0;  // [1/m], of a car's steering
};

}  // namespace pomdp_crowd_nav
