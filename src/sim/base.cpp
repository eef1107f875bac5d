// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/sim/base.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace pomdp_crowd_nav {
namespace {

constexpr double kSubstep = 0.01;  // [s]

// Shortened to `max_norm`, direction kept.
Point capped(const Point& velocity, double max_norm) {
  const double norm = velocity.norm();
  return norm > max_norm ? Point(max_norm / norm * velocity) : velocity;
}

double approach(double value, double target, double max_change) {
  return value + std::clamp(target - value, -max_change, max_change);
}

// One axis of the velocity after `duration`: first down to the target or to rest with `brake`,
// then up to the target with `accelerate`.
double axisAfter(double value, double target, double accelerate, double brake, double duration) {
  const bool reverses = value * target < 0.0;
  if (!reverses && std::abs(target) >= std::abs(value)) {
    return approach(value, target, accelerate * duration);
  }
  const double slowest = reverses ? 0.0 : target;
  const double braking_time = std::abs(value - slowest) / brake;
  if (braking_time >= duration) return approach(value, slowest, brake * duration);
  return approach(slowest, target, accelerate * (duration - braking_time));
}

}  // namespace

SimulatedBase::SimulatedBase(const VehicleParams& params, const Pose& start) : params_(params) {
  validate(params);
  place(start);
}

void SimulatedBase::place(const Pose& pose) {
  pose_ = {pose.position, wrapAngle(pose.heading)};
  velocity_ = Point::Zero();
  yaw_rate_ = 0.0;
  curvature_ = 0.0;
}

void SimulatedBase::follow(const BaseCommand& command, double duration) {
  if (!(duration > 0.0)) return;
  const Point body_velocity = command.velocity.allFinite() ? command.velocity : Point(0.0, 0.0);
  const double yaw_rate = std::isfinite(command.yaw_rate) ? command.yaw_rate : 0.0;
  if (params_.kind == VehicleKind::kCar) {
    followCar(body_velocity.x(), yaw_rate, duration);
    return;
  }
  const Eigen::Rotation2Dd body(pose_.heading);  // held while the body turns
  const Point target = capped(body_velocity, params_.max_speed);
  const double yaw_target = std::clamp(yaw_rate, -params_.max_yaw_rate, params_.max_yaw_rate);

  if (params_.instant_velocity) {
    velocity_ = body * target;
    yaw_rate_ = yaw_target;
    move(velocity_, yaw_rate_, duration);
    return;
  }
  const int substeps = std::max(1, static_cast<int>(std::ceil(duration / kSubstep)));
  for (int i = 0; i < substeps; ++i) ramp(body, target, yaw_target, duration / substeps);
}

void SimulatedBase::followCar(double speed, double yaw_rate, double duration) {
  const double target = std::clamp(speed, 0.0, params_.max_speed);
  if (target > 0.0) {
    const double tightest = std::min(maxCurvature(params_), params_.max_yaw_rate / target);
    curvature_ = std::clamp(yaw_rate / target, -tightest, tightest);
  }
  if (params_.instant_velocity) {
    velocity_ = target * unitVector(pose_.heading);
    driveArc(target, duration);
    return;
  }
  const int substeps = std::max(1, static_cast<int>(std::ceil(duration / kSubstep)));
  const double period = duration / substeps;
  for (int i = 0; i < substeps; ++i) {
    driveArc(axisAfter(velocity_.norm(), target, params_.acceleration, params_.brake_deceleration,
                       period),
             period);
  }
}

// At a speed that changes linearly from the present one.
void SimulatedBase::driveArc(double speed_after, double duration) {
  const double length = 0.5 * (velocity_.norm() + speed_after) * duration;
  const PathLeg arc{pose_.heading, curvature_ * length, length};
  pose_ = {pose_.position + arc.displacement(length), wrapAngle(pose_.heading + arc.turn)};
  velocity_ = speed_after * unitVector(pose_.heading);
  yaw_rate_ = curvature_ * speed_after;
}

void SimulatedBase::ramp(const Eigen::Rotation2Dd& body, const Point& target, double yaw_target,
                         double duration) {
  const Point before = body.inverse() * velocity_;
  const double brake = params_.brake_deceleration;
  Point after(axisAfter(before.x(), target.x(), params_.acceleration, brake, duration),
              axisAfter(before.y(), target.y(), params_.lateral_acceleration, brake, duration));
  after = capped(after, params_.max_speed);
  const double yaw_after = approach(yaw_rate_, yaw_target, params_.yaw_acceleration * duration);

  move(body * Point(0.5 * (before + after)), 0.5 * (yaw_rate_ + yaw_after), duration);
  velocity_ = body * after;
  yaw_rate_ = yaw_after;
}

void SimulatedBase::move(const Point& mean_velocity, double mean_yaw_rate, double duration) {
  pose_.position += duration * mean_velocity;
  pose_.heading = wrapAngle(pose_.heading + duration * mean_yaw_rate);
}

}  // namespace pomdp_crowd_nav
