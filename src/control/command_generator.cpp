// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/control/command_generator.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace pomdp_crowd_nav {
namespace {

constexpr double kRestSpeed = 1e-3;     // [m/s], commands slower than this are zero
constexpr double kLongestPeriod = 0.2;  // [s], of commands; a longer silence allows no more change

// `value` changed toward `target` by at most `change`.
double toward(double value, double target, double change) {
  return value + std::clamp(target - value, -change, change);
}

Point cappedTo(const Point& velocity, double max_speed) {
  const double speed = velocity.norm();
  return speed > max_speed ? Point(velocity * (max_speed / speed)) : velocity;
}

Point finiteOrZero(const Point& p) { return p.allFinite() ? p : Point(0.0, 0.0); }

// What to command at `time` seconds into a motion, until the next command `period` later. A ramp is
// followed without lag by the velocity to have by then, legs by the mean velocity along them.
Point velocityFor(const StepMotion& motion, double time, double period) {
  if (motion.legs.empty() || period <= 0.0) return motion.velocityAt(time + period);
  return (motion.positionAt(time + period) - motion.positionAt(time)) / period;
}

}  // namespace

CommandGenerator::CommandGenerator(const Params& params, const VehicleParams& vehicle)
    : params_(params), vehicle_(vehicle) {
  validate(vehicle);
  if (params.hold_time >= 0.0 && params.yaw_gain >= 0.0) return;
  throw std::invalid_argument("hold_time and yaw_gain must not be negative");
}

void CommandGenerator::follow(const StepMotion& motion, double start_time) {
  motion_ = motion;
  start_time_ = start_time;
}

void CommandGenerator::stop() { motion_.reset(); }

// Also long before the motion begins: then the clock jumped back, and its times mean nothing.
bool CommandGenerator::isStopping(double now) const {
  if (!motion_) return true;
  const double begin = start_time_ - motion_->duration;
  const double end = start_time_ + motion_->duration + params_.hold_time;
  return !(now >= begin && now <= end);
}

BaseCommand CommandGenerator::commandAt(double now, double yaw, const Point& velocity) {
  const bool has_time = std::isfinite(now);
  const double period = has_time ? std::clamp(now - last_time_, 0.0, kLongestPeriod) : 0.0;
  if (has_time) last_time_ = now;
  Point target(0.0, 0.0);
  double desired_yaw = yaw;
  if (isStopping(now)) {
    const Point measured = finiteOrZero(velocity);
    // Braking starts from what was commanded, or from what is measured when that is slower.
    const Point from = measured.norm() < last_velocity_.norm() ? measured : last_velocity_;
    const double slowed = speedAfterBrake(vehicle_, from.norm(), period);
    target = slowed > kRestSpeed ? Point(from.normalized() * slowed) : Point(0.0, 0.0);
  } else {
    target = finiteOrZero(velocityFor(*motion_, now - start_time_, period));
    if (target.norm() > kRestSpeed) desired_yaw = std::atan2(target.y(), target.x());
  }
  return limited(target, yaw, desired_yaw, period);
}

BaseCommand CommandGenerator::limited(const Point& velocity, double yaw, double desired_yaw,
                                      double period) {
  last_velocity_ = cappedTo(velocity, vehicle_.max_speed);
  if (!std::isfinite(yaw)) {
    // Without a heading no velocity can be turned into the base frame.
    last_velocity_ = Point(0.0, 0.0);
    last_yaw_rate_ = 0.0;
    return {};
  }
  const double wanted = std::clamp(params_.yaw_gain * wrapAngle(desired_yaw - yaw),
                                   -vehicle_.max_yaw_rate, vehicle_.max_yaw_rate);
  last_yaw_rate_ = vehicle_.instant_velocity
                       ? wanted
                       : toward(last_yaw_rate_, wanted, vehicle_.yaw_acceleration * period);
  BaseCommand command;
  const double c = std::cos(yaw);
  const double s = std::sin(yaw);
  command.velocity = {c * last_velocity_.x() + s * last_velocity_.y(),
                      -s * last_velocity_.x() + c * last_velocity_.y()};
  command.yaw_rate = last_yaw_rate_;
  return command;
}

}  // namespace pomdp_crowd_nav
