// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "pomdp_crowd_nav/world/base_command.h"
#include "pomdp_crowd_nav/world/vehicle.h"

namespace pomdp_crowd_nav {

// Turns the motion of the newest decision into velocity commands, at any rate.
//
// A motion is followed until `hold_time` after its end; then, and whenever there is none, the base
// is braked to rest, a car on the curve that it is on. Commands are finite and within the vehicle's
// limits whatever comes in.
class CommandGenerator {
 public:
  struct Params {
    double hold_time = 0.1;  // [s] a motion is held past its end before the base is braked
    double yaw_gain = 2.0;   // [1/s], yaw rate per angle between body and direction of travel
  };

  CommandGenerator(const Params& params, const VehicleParams& vehicle);

  void follow(const StepMotion& motion, double start_time);
  // Brakes to rest from now on, until the next `follow`.
  void stop();

  bool isStopping(double now) const;

  // Command for the base at time `now`; `yaw` is the body's heading in the planning frame and
  // `velocity` [m/s] its measured velocity there.
  BaseCommand commandAt(double now, double yaw, const Point& velocity);

 private:
  Point wantedVelocity(double time, double period) const;
  BaseCommand commandCar(double now, double period, double yaw, double speed);
  void steerAlong(double time, double period, double yaw);
  BaseCommand limited(const Point& velocity, double yaw, double desired_yaw, double period);

  Params params_;
  VehicleParams vehicle_;
  std::optional<StepMotion> motion_;
  double start_time_ = 0.0;
  double last_time_ = 0.0;
  double last_yaw_rate_ = 0.0;
  Point last_velocity_{0.0, 0.0};  // commanded, planning frame
  double last_speed_ = 0.0;        // [m/s], commanded to a car
  double last_curvature_ = 0.0;    // [1/m], the same
};

}  // namespace pomdp_crowd_nav
