// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/control/emergency_override.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace pomdp_crowd_nav {
namespace {

// Smallest distance between two points that move at constant velocity for `duration` seconds.
double closestApproach(const Point& offset, const Point& velocity, double duration) {
  const double speed_squared = velocity.squaredNorm();
  if (speed_squared == 0.0) return offset.norm();
  const double time = std::clamp(-offset.dot(velocity) / speed_squared, 0.0, duration);
  return (offset + time * velocity).norm();
}

// The same of a car that drives a curve, piece by piece. A person who is close but falls behind
// counts as far away.
double closestOnCurve(const VehicleState& car, double yaw_rate, const Track& track,
                      double duration) {
  constexpr double kPiece = 0.1;  // [s]
  const PathLeg curve{car.heading, yaw_rate * duration, car.speed * duration};
  const int pieces = std::max(1, static_cast<int>(std::ceil(duration / kPiece)));
  const double piece = duration / pieces;
  double closest = std::numeric_limits<double>::infinity();
  Point offset = track.position - car.position;
  for (int i = 1; i <= pieces; ++i) {
    const Point next = track.position + i * piece * track.velocity - car.position -
                       curve.displacement(curve.length * i / pieces);
    const Point velocity = (next - offset) / piece;
    if (offset.dot(velocity) < 0.0) {
      closest = std::min(closest, closestApproach(offset, velocity, piece));
    }
    offset = next;
  }
  return closest;
}

}  // namespace

EmergencyOverride::EmergencyOverride(const Params& params, const VehicleParams& vehicle,
                                     double step)
    : params_(params), vehicle_(vehicle), step_(step) {
  if (params.decision_distance >= 0.0 && params.reflex_distance >= 0.0 &&
      params.reaction_time >= 0.0) {
    return;
  }
  throw std::invalid_argument("emergency distances and reaction_time must not be negative");
}

std::optional<Action> EmergencyOverride::replace(const VehicleState& vehicle,
                                                 const TrackList& tracks) const {
  if (!params_.enabled) return std::nullopt;
  const auto close = [&](const Track& track) {
    return (track.position - vehicle.position).norm() <= params_.decision_distance;
  };
  if (std::none_of(tracks.tracks.begin(), tracks.tracks.end(), close)) return std::nullopt;
  if (vehicle.speed <= 0.0) return Action::turnBy(0.0, 0);
  const double slowed = speedAfter(vehicle_, vehicle.speed, -vehicle_.acceleration * step_);
  return slowed <= 0.0 ? Action::turnBy(0.0, -1) : Action::suddenBrake();
}

std::optional<std::int64_t> EmergencyOverride::reflex(const VehicleState& vehicle,
                                                      const TrackList& tracks,
                                                      double yaw_rate) const {
  if (!params_.enabled || vehicle.speed <= 0.0) return std::nullopt;
  const double braking =
      vehicle_.instant_velocity ? 0.0 : vehicle.speed / vehicle_.brake_deceleration;
  const bool on_curve =
      vehicle_.kind == VehicleKind::kCar && !vehicle_.instant_velocity && yaw_rate != 0.0;
  for (const Track& track : tracks.tracks) {
    if (on_curve) {
      const double duration = params_.reaction_time + braking;
      const double closest = closestOnCurve(vehicle, yaw_rate, track, duration);
      if (closest <= params_.reflex_distance) return track.id;
      continue;
    }
    const Point offset = track.position - vehicle.position;
    const Point velocity = track.velocity - vehicle.velocity();
    // A person who is close but falls behind is no reason to stop.
    const bool approaches = offset.dot(velocity) < 0.0;
    const double duration = params_.reaction_time + braking;
    if (approaches && closestApproach(offset, velocity, duration) <= params_.reflex_distance) {
      return track.id;
    }
  }
  return std::nullopt;
}

void EmergencyOverride::apply(const Action& action, const VehicleState& vehicle,
                              Decision& decision) const {
  const double speed =
      action.sudden_brake
          ? speedAfterBrake(vehicle_, vehicle.speed, step_)
          : speedAfter(vehicle_, vehicle.speed, action.speed_steps * vehicle_.acceleration * step_);
  decision.action = action;
  decision.motion = stepMotion(vehicle_, vehicle, vehicle.heading, speed, step_);
  decision.plan = {vehicle, decision.motion.end()};
}

}  // namespace pomdp_crowd_nav
