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
  if (vehicle_.kind == VehicleKind::kCar) {
    return commandCar(now, period, yaw, finiteOrZero(velocity).norm());
  }
  Point target(0.0, 0.0);
  double desired_yaw = yaw;
  if (isStopping(now)) {
    const Point measured = finiteOrZero(velocity);
    // Braking starts from what was commanded, or from what is measured when that is slower.
    const Point from = measured.norm() < last_velocity_.norm() ? measured : last_velocity_;
    const double slowed = speedAfterBrake(vehicle_, from.norm(), period);
    target = slowed > kRestSpeed ? Point(from.normalized() * slowed) : Point(0.0, 0.0);
  } else {
    target = finiteOrZero(wantedVelocity(now - start_time_, period));
    if (target.norm() > kRestSpeed) desired_yaw = std::atan2(target.y(), target.x());
  }
  return limited(target, yaw, desired_yaw, period);
}

// A ramp is followed without lag by the velocity to have when the next command comes, a bent way
// without drift by the mean velocity until then.
Point CommandGenerator::wantedVelocity(double time, double period) const {
  const bool bends = motion_->instant && !motion_->legs.empty() && period > 0.0;
  if (!bends) return motion_->velocityAt(time + period);
  return (motion_->positionAt(time + period) - motion_->positionAt(time)) / period;
}

// A car faces where it drives: no velocity but a forward one, and no turn without it.
BaseCommand CommandGenerator::commandCar(double now, double period, double yaw, double speed) {
  if (isStopping(now)) {
    const double slowed = speedAfterBrake(vehicle_, std::min(last_speed_, speed), period);
    last_speed_ = slowed > kRestSpeed ? slowed : 0.0;
  } else {
    steerAlong(now - start_time_, period, yaw);
  }
  const double tightest = maxCurvature(vehicle_);
  last_speed_ = std::clamp(std::isfinite(last_speed_) ? last_speed_ : 0.0, 0.0, vehicle_.max_speed);
  last_curvature_ =
      std::clamp(std::isfinite(last_curvature_) ? last_curvature_ : 0.0, -tightest, tightest);
  BaseCommand command;
  command.velocity = {last_speed_, 0.0};
  command.yaw_rate =
      std::clamp(last_curvature_ * last_speed_, -vehicle_.max_yaw_rate, vehicle_.max_yaw_rate);
  return command;
}

// Speed and curvature of the way that is driven until the next command; an instant base needs the
// mean speed, another the one to have by then.
void CommandGenerator::steerAlong(double time, double period, double yaw) {
  const double driven = motion_->distanceAt(time + period) - motion_->distanceAt(time);
  const bool needs_mean = vehicle_.instant_velocity && period > 0.0 && !motion_->legs.empty();
  last_speed_ = needs_mean ? driven / period : motion_->velocityAt(time + period).norm();
  const double heading = motion_->headingAt(time);
  const double turn = wrapAngle(motion_->headingAt(time + period) - heading);
  last_curvature_ = driven > 0.0 ? turn / driven : 0.0;
  if (!std::isfinite(yaw) || last_speed_ <= kRestSpeed) return;
  last_curvature_ += params_.yaw_gain * wrapAngle(heading - yaw) / last_speed_;
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
