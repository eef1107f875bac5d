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

void requireAngle(const char* name, double value, const char* limit, double most) {
  if (value > 0.0 && value <= most) return;
  throw std::invalid_argument(
      fmt::format("{} must be positive and {} rad, got {}", name, limit, value));
}

double lengthOf(const std::vector<PathLeg>& legs) {
  double length = 0.0;
  for (const PathLeg& leg : legs) length += leg.length;
  return length;
}

double fastestOf(const StepMotion& motion) {
  const double end = motion.end_velocity.norm();
  return motion.instant ? end : std::max(motion.start_velocity.norm(), end);
}

// One arc for a car that ends the step at `speed`, turned by as much of `turn` as it can.
void driveArc(const VehicleParams& params, const VehicleState& from, double turn, double speed,
              StepMotion& motion) {
  motion.end_velocity = speed * unitVector(from.heading);
  const double mean = motion.instant ? speed : 0.5 * (from.speed + speed);
  const double length = mean * motion.duration;
  const double most = maxArcTurn(params, length, fastestOf(motion));
  const double turned = std::clamp(turn, -most, most);
  motion.end_heading = wrapAngle(from.heading + turned);
  motion.end_velocity = speed * unitVector(motion.end_heading);
  if (length > 0.0) motion.legs = {{from.heading, turned, length}};
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
  requirePositive("wheelbase", params.wheelbase);
  requireAngle("max_steering_angle", params.max_steering_angle, "below pi / 2", 1.57);
  requireAngle("max_turn_per_step", params.max_turn_per_step, "at most pi / 2", 1.5708);
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

double maxCurvature(const VehicleParams& params) {
  return std::tan(params.max_steering_angle) / params.wheelbase;
}

double maxCurvature(const VehicleParams& params, double speed) {
  double curvature = maxCurvature(params);
  if (speed > 0.0) curvature = std::min(curvature, params.max_yaw_rate / speed);
  if (speed > 0.0 && !params.instant_velocity) {
    curvature = std::min(curvature, params.lateral_acceleration / (speed * speed));
  }
  return curvature;
}

double maxArcTurn(const VehicleParams& params, double length, double fastest) {
  return std::min(params.max_turn_per_step, maxCurvature(params, fastest) * length);
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
  const double speed = end_velocity.norm();
  const double within = std::min(time, duration);
  const double ramp = std::max(0.0, within);
  const double from = start_velocity.norm();
  const double driven =
      instant ? within * speed : ramp * from + 0.5 * ramp * ramp / duration * (speed - from);
  return std::min(driven, lengthOf(legs)) + (time - within) * speed;
}

Point StepMotion::velocityAt(double time) const {
  const double share = instant ? 1.0 : std::clamp(time / duration, 0.0, 1.0);
  if (legs.empty()) return start_velocity + share * (end_velocity - start_velocity);
  constexpr double kRounding = 1e-9;  // [s]
  const bool has_ended = time < duration - kRounding && distanceAt(time) >= lengthOf(legs);
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
  motion.duration = step;
  motion.instant = params.instant_velocity;
  if (params.kind == VehicleKind::kCar) {
    driveArc(params, from, wrapAngle(heading - from.heading), speed, motion);
    return motion;
  }
  motion.end_heading = turnToward(from.heading, heading, maxTurnChord(params, from.speed, step));
  motion.end_velocity = speed * unitVector(motion.end_heading);
  return motion;
}

std::optional<PathLeg> arcTo(const VehicleState& from, const Point& place) {
  // Between an arc's chord and the heading at its beginning lies half of its turn.
  const Point way = place - from.position;
  const double half = wrapAngle(bearing(from.position, place) - from.heading);
  if (std::abs(half) >= 0.5 * M_PI) return std::nullopt;
  const double stretch = std::abs(half) < 1e-9 ? 1.0 : half / std::sin(half);
  return PathLeg{from.heading, 2.0 * half, way.norm() * stretch};
}

std::optional<StepMotion> stopAt(const VehicleParams& params, const Point& place,
                                 const VehicleState& from, const StepMotion& motion) {
  const std::optional<PathLeg> arc = arcTo(from, place);
  if (!arc || motion.legs.empty() || arc->length > motion.legs.front().length) return std::nullopt;
  const double fastest = fastestOf(motion);
  if (std::abs(arc->turn) > maxArcTurn(params, arc->length, fastest)) return std::nullopt;
  StepMotion stopped = motion;
  stopped.legs = {*arc};
  stopped.end_heading = wrapAngle(from.heading + arc->turn);
  double speed = 0.0;
  if (motion.instant) {
    const double share = arc->length / motion.legs.front().length;
    speed = share * motion.end_velocity.norm();
    stopped.start_velocity *= share;
  } else {
    speed = 2.0 * arc->length / motion.duration - from.speed;
    if (speed < speedAfter(params, from.speed, -params.acceleration * motion.duration)) {
      return std::nullopt;
    }
  }
  stopped.end_velocity = speed * unitVector(stopped.end_heading);
  return stopped;
}

}  // namespace pomdp_crowd_nav
