// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/control/stopping_path.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace pomdp_crowd_nav {
namespace {

constexpr double kSamplePeriod = 0.05;  // [s]
constexpr double kFastestPerson = 5.0;  // [m/s], what is said to be faster is taken for this

Point creditable(const Point& velocity) {
  const double speed = std::hypot(velocity.x(), velocity.y());
  if (!std::isfinite(speed)) return {0.0, 0.0};
  return speed > kFastestPerson ? Point(velocity * (kFastestPerson / speed)) : velocity;
}

}  // namespace

StoppingPath::StoppingPath(const Params& params, const VehicleParams& vehicle)
    : params_(params), vehicle_(vehicle) {
  if (params.distance > 0.0 && params.reaction_time >= 0.0) return;
  throw std::invalid_argument(
      fmt::format("the distance from people must be positive and the reaction time not negative, "
                  "got {} m and {} s",
                  params.distance, params.reaction_time));
}

double StoppingPath::duration(double speed) const {
  const double braking = vehicle_.instant_velocity ? 0.0 : speed / vehicle_.brake_deceleration;
  return params_.reaction_time + braking;
}

double StoppingPath::length(double speed) const {
  return speed * params_.reaction_time + stoppingDistance(vehicle_, speed);
}

double StoppingPath::distanceAt(double time, double speed) const {
  const double reaction = std::min(time, params_.reaction_time);
  const double braking = std::min(time, duration(speed)) - reaction;
  return speed * (reaction + braking) - 0.5 * vehicle_.brake_deceleration * braking * braking;
}

std::vector<StoppingPath::Sample> StoppingPath::sample(const VehicleState& robot,
                                                       double curvature) const {
  const double total = length(robot.speed);
  const PathLeg path{robot.heading, curvature * total, total};
  const double end = duration(robot.speed);
  const int count = static_cast<int>(std::ceil(end / kSamplePeriod)) + 1;
  std::vector<Sample> samples;
  samples.reserve(static_cast<size_t>(count));
  for (int i = 0; i < count; ++i) {
    const double time = std::min(end, i * kSamplePeriod);
    const double driven = distanceAt(time, robot.speed);
    samples.push_back(
        {time, robot.position + path.displacement(driven), unitVector(path.headingAt(driven))});
  }
  return samples;
}

std::optional<std::int64_t> StoppingPath::blockedBy(const VehicleState& robot, double curvature,
                                                    const std::vector<Track>& people) const {
  if (!(robot.speed > 0.0)) return std::nullopt;
  const double reach =
      params_.distance + length(robot.speed) + kFastestPerson * duration(robot.speed);
  std::vector<Sample> samples;
  for (const Track& person : people) {
    if (!((person.position - robot.position).norm() <= reach)) continue;
    if (samples.empty()) samples = sample(robot, curvature);
    if (isBlockedBy(person, samples)) return person.id;
  }
  return std::nullopt;
}

// The first time that the distance is too small decides who runs into whom.
bool StoppingPath::isBlockedBy(const Track& person, const std::vector<Sample>& samples) const {
  const Point velocity = creditable(person.velocity);
  Point before = person.position - samples.front().position;
  for (size_t i = 0; i < samples.size(); ++i) {
    const Sample& sample = samples[i];
    const Point after = person.position + sample.time * velocity - sample.position;
    if (distanceToSegment(Point(0.0, 0.0), before, after) <= params_.distance) {
      return before.dot(samples[i == 0 ? 0 : i - 1].direction) > 0.0;
    }
    before = after;
  }
  return false;
}

}  // namespace pomdp_crowd_nav
