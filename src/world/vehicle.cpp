// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/world/vehicle.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace pomdp_crowd_nav {
namespace {

void requirePositive(const char* name, double value) {
  if (value > 0.0 && std::isfinite(value)) return;
  throw std::invalid_argument(fmt::format("{} must be positive, got {}", name, value));
}

}  // namespace

void validate(const VehicleParams& params) {
  requirePositive("robot_radius", params.radius);
  requirePositive("max_vel_trans", params.max_speed);
  requirePositive("acc_lim_x", params.acceleration);
  requirePositive("acc_lim_y", params.lateral_acceleration);
  requirePositive("brake_deceleration", params.brake_deceleration);
  requirePositive("max_vel_theta", params.max_yaw_rate);
  requirePositive("acc_lim_theta", params.yaw_acceleration);
}

double speedAfter(const VehicleParams& params, double speed, double speed_change) {
  return std::clamp(speed + speed_change, 0.0, params.max_speed);
}

double speedAfterBrake(const VehicleParams& params, double speed, double step) {
  if (params.instant_velocity) return 0.0;
  return std::max(0.0, speed - params.brake_deceleration * step);
}

double stoppingDistance(const VehicleParams& params, double speed) {
  if (params.instant_velocity) return 0.0;
  return speed * speed / (2.0 * params.brake_deceleration);
}

double maxTurnChord(const VehicleParams& params, double speed, double step) {
  constexpr double kAnyTurn = 2.0;
  if (params.instant_velocity) return kAnyTurn;
  const double velocity_change = params.lateral_acceleration * step;
  return velocity_change >= kAnyTurn * speed ? kAnyTurn : velocity_change / speed;
}

double turnToward(double heading, double desired, double max_chord) {
  const double turn = wrapAngle(desired - heading);
  const double max_turn = 2.0 * std::asin(std::min(1.0, 0.5 * max_chord));
  return wrapAngle(heading + std::clamp(turn, -max_turn, max_turn));
}

Point PathLeg::displacement(double distance) const {
  // The chord of an arc, which points half its turn away from where it begins.
  const double half = length > 0.0 ? 0.5 * turn * distance / length : 0.0;
  const double shortening = std::abs(half) < 1e-9 ? 1.0 : std::sin(half) / half;
  return distance * shortening * unitVector(heading + half);
}

double PathLeg::headingAt(double distance) const {
  return length > 0.0 ? wrapAngle(heading + turn * distance / length) : heading;
}

double StepMotion::distanceAt(double time) const {
  if (instant) return time * end_velocity.norm();
  const double ramp = std::clamp(time, 0.0, duration);
  const double from = start_velocity.norm();
  return ramp * from + 0.5 * ramp * ramp / duration * (end_velocity.norm() - from);
}

Point StepMotion::velocityAt(double time) const {
  const double share = instant ? 1.0 : std::clamp(time / duration, 0.0, 1.0);
  if (legs.empty()) return start_velocity + share * (end_velocity - start_velocity);
  double length = 0.0;
  for (const PathLeg& leg : legs) length += leg.length;
  const bool has_ended = time < duration && distanceAt(time) >= length;
  if (has_ended) return {0.0, 0.0};
  const double from = start_velocity.norm();
  return (from + share * (end_velocity.norm() - from)) * unitVector(headingAt(time));
}

Point StepMotion::positionAt(double time) const {
  const double within = std::min(time, duration);
  const Point beyond = std::max(0.0, time - duration) * end_velocity;
  if (!legs.empty()) {
    Point position = start;
    double left = distanceAt(within);
    for (const PathLeg& leg : legs) {
      const double driven = std::min(left, leg.length);
      position += leg.displacement(driven);
      left -= driven;
    }
    return position + beyond;
  }
  if (instant) return start + time * end_velocity;
  const double ramp = std::max(0.0, within);
  const Point ramped = start + ramp * start_velocity +
                       0.5 * ramp * ramp / duration * (end_velocity - start_velocity);
  return ramped + (time - ramp) * end_velocity;
}

double StepMotion::headingAt(double time) const {
  double left = distanceAt(std::min(time, duration));
  for (const PathLeg& leg : legs) {
    if (left < leg.length) return leg.headingAt(left);
    left -= leg.length;
  }
  return end_heading;
}

VehicleState StepMotion::end() const {
  return {positionAt(duration), end_heading, end_velocity.norm()};
}

StepMotion stepMotion(const VehicleParams& params, const VehicleState& from, double heading,
                      double speed, double step) {
  StepMotion motion;
  motion.start = from.position;
  motion.start_velocity = from.velocity();
  motion.end_heading = turnToward(from.heading, heading, maxTurnChord(params, from.speed, step));
  motion.end_velocity = speed * unitVector(motion.end_heading);
  motion.duration = step;
  motion.instant = params.instant_velocity;
  return motion;
}

}  // namespace pomdp_crowd_nav
