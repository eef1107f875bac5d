// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>

#include "pomdp_crowd_nav/world/base_command.h"
#include "pomdp_crowd_nav/world/vehicle.h"

namespace pomdp_crowd_nav {

// Cuts a stream of commands to the limits of a vehicle. What comes out is never faster than what
// goes in, keeps its direction, and never grows faster than the vehicle accelerates.
//
// Speed and yaw rate of a holonomic base are cut each for itself, those of a car together, so that
// it keeps its curve. Slowing down is not limited: the base has a brake of its own.
class VelocityLimiter {
 public:
  static constexpr double kNoCap = std::numeric_limits<double>::infinity();

  explicit VelocityLimiter(const VehicleParams& vehicle);

  // Most that is let through besides the vehicle's limits.
  struct Caps {
    double speed = kNoCap;     // [m/s]
    double yaw_rate = kNoCap;  // [rad/s]
  };

  // `period` [s] since the last call; `measured` is the base's velocity in its own frame, from
  // which it may accelerate on.
  BaseCommand limit(const BaseCommand& wanted, const Caps& caps, double period,
                    const Point& measured = {0.0, 0.0});

  // What remains of the last output after `period` of braking; from the measured speed where that
  // is lower.
  Caps brakingCaps(double period, double measured_speed = kNoCap) const;

  const BaseCommand& last() const { return last_; }

 private:
  double speedLimit(const Point& direction, const Point& measured) const;

  VehicleParams vehicle_;
  BaseCommand last_;
  double spare_speed_ = 0.0;     // [m/s] that the output may grow by now
  double spare_yaw_rate_ = 0.0;  // [rad/s], the same
};

}  // namespace pomdp_crowd_nav
