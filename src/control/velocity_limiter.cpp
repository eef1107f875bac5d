// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/control/velocity_limiter.h"

#include <algorithm>
#include <cmath>

namespace pomdp_crowd_nav {
namespace {

constexpr double kSpareTime = 0.1;     // [s] of acceleration saved up for commands that come late
constexpr double kRestSpeed = 1e-3;    // [m/s], what brakes is at rest below
constexpr double kRestYawRate = 1e-3;  // [rad/s]

double speedOf(const Point& velocity) { return std::hypot(velocity.x(), velocity.y()); }

double share(double limit, double value) { return value > limit ? limit / value : 1.0; }

}  // namespace

VelocityLimiter::VelocityLimiter(const VehicleParams& vehicle) : vehicle_(vehicle) {
  validate(vehicle);
}

// A step of the planner's model changes the velocity by at most both accelerations together.
BaseCommand VelocityLimiter::limit(const BaseCommand& wanted, const Caps& caps, double period,
                                   const Point& measured) {
  const double growth = vehicle_.acceleration + vehicle_.lateral_acceleration;
  spare_speed_ = std::min(spare_speed_ + growth * period, growth * kSpareTime);
  spare_yaw_rate_ = std::min(spare_yaw_rate_ + vehicle_.yaw_acceleration * period,
                             vehicle_.yaw_acceleration * kSpareTime);

  const double speed = speedOf(wanted.velocity);
  const double yaw_rate = std::abs(wanted.yaw_rate);
  const Point direction = speed > 0.0 ? Point(wanted.velocity / speed) : Point(0.0, 0.0);
  const double base_speed = speedLimit(direction, measured);
  const double base_yaw_rate =
      wanted.yaw_rate * last_.yaw_rate > 0.0 ? std::abs(last_.yaw_rate) : 0.0;
  double most_speed = std::min(vehicle_.max_speed, caps.speed);
  double most_yaw_rate = std::min(vehicle_.max_yaw_rate, caps.yaw_rate);
  if (!vehicle_.instant_velocity) {
    most_speed = std::min(most_speed, base_speed + spare_speed_);
    if (vehicle_.kind != VehicleKind::kCar) {
      most_yaw_rate = std::min(most_yaw_rate, base_yaw_rate + spare_yaw_rate_);
    }
  }

  double speed_share = share(most_speed, speed);
  double yaw_share = share(most_yaw_rate, yaw_rate);
  if (vehicle_.kind == VehicleKind::kCar)
    speed_share = yaw_share = std::min(speed_share, yaw_share);
  last_.velocity = speed_share * wanted.velocity;
  last_.yaw_rate = yaw_share * wanted.yaw_rate;
  if (!last_.velocity.allFinite() || !std::isfinite(last_.yaw_rate)) last_ = BaseCommand();
  spare_speed_ -= std::clamp(speedOf(last_.velocity) - base_speed, 0.0, spare_speed_);
  spare_yaw_rate_ -= std::clamp(std::abs(last_.yaw_rate) - base_yaw_rate, 0.0, spare_yaw_rate_);
  return last_;
}

// Speed in that direction that the base has already, or was told to have.
double VelocityLimiter::speedLimit(const Point& direction, const Point& measured) const {
  const double driven = measured.dot(direction);
  const double known = std::isfinite(driven) ? std::min(driven, vehicle_.max_speed) : 0.0;
  return std::max({0.0, known, last_.velocity.dot(direction)});
}

VelocityLimiter::Caps VelocityLimiter::brakingCaps(double period, double measured_speed) const {
  const double from = std::min(speedOf(last_.velocity), measured_speed);
  Caps caps;
  caps.speed = speedAfterBrake(vehicle_, from, period);
  if (caps.speed < kRestSpeed) caps.speed = 0.0;
  if (vehicle_.kind == VehicleKind::kCar) return caps;  // its yaw rate goes with its speed
  const double turning = std::abs(last_.yaw_rate) - vehicle_.yaw_acceleration * period;
  caps.yaw_rate = vehicle_.instant_velocity || turning < kRestYawRate ? 0.0 : turning;
  return caps;
}

}  // namespace pomdp_crowd_nav
