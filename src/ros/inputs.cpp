// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/ros/inputs.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace pomdp_crowd_nav {
namespace {

bool happenedWithin(double moment, double duration, double now) {
  return moment >= 0.0 && now - moment <= duration;
}

}  // namespace

void InputTraffic::noteArrival(const std::string& frame_id, double now) {
  frame = frame_id;
  rate.count(now);
}

void InputTraffic::noteRefusal(MessageFault fault, double now) {
  refused_at = now;
  last_fault = fault;
  ++refused[static_cast<size_t>(fault)];
}

unsigned InputTraffic::refusals() const {
  return std::accumulate(refused.begin(), refused.end(), 0u);
}

void Inputs::noteTracks(double measured_at, double gap, bool is_afresh) {
  const bool continues = !is_afresh && happenedWithin(tracks_at, gap, measured_at);
  if (!continues) first_tracks_at = measured_at;
  tracks_at = measured_at;
}

double longestGap(double people_timeout) {
  constexpr double kLeast = 1.0;  // [s]
  return std::max(kLeast, people_timeout);
}

bool isPoseJump(const RobotReading& from, const RobotReading& to, double max_speed) {
  constexpr double kSlack = 1.0;  // [m], corrections of the localisation are smaller
  const double way = (to.pose.position - from.pose.position).norm();
  return way > max_speed * std::max(0.0, to.measured_at - from.measured_at) + kSlack;
}

StopCause missingOdometry(const Inputs& inputs, const InputLimits& limits, double now) {
  if (inputs.robot && now - inputs.robot->measured_at <= limits.odometry) return StopCause::kNone;
  const bool is_refused = happenedWithin(inputs.odometry_traffic.refused_at, limits.odometry, now);
  return is_refused ? StopCause::kOdometryRefused : StopCause::kNoOdometry;
}

StopCause missingPeople(const Inputs& inputs, const InputLimits& limits, double now) {
  if (!happenedWithin(inputs.tracks_at, limits.people, now)) {
    const bool is_refused = happenedWithin(inputs.people_traffic.refused_at, limits.people, now);
    return is_refused ? StopCause::kPeopleRefused : StopCause::kNoPeople;
  }
  const bool is_new = inputs.tracks_at - inputs.first_tracks_at < limits.watching;
  return is_new ? StopCause::kWatchingPeople : StopCause::kNone;
}

StopCause missingMap(const Inputs& inputs, const InputLimits& limits, double now) {
  const bool is_old = limits.map > 0.0 && now - inputs.map_at > limits.map;
  if (inputs.map && !is_old) return StopCause::kNone;
  const bool is_refused = inputs.map_traffic.refused_at > inputs.map_at;
  return is_refused ? StopCause::kMapRefused : StopCause::kNoMap;
}

StopCause missingClock(const Inputs& inputs, const InputLimits& limits, double now) {
  const bool is_watched = inputs.clock_at >= 0.0;
  const bool moves = happenedWithin(inputs.clock_at, limits.clock, now);
  return !is_watched || moves ? StopCause::kNone : StopCause::kClockStandsStill;
}

StopCause missingInput(const Inputs& inputs, const InputLimits& limits, double now) {
  const StopCause clock = missingClock(inputs, limits, now);
  if (clock != StopCause::kNone) return clock;
  const StopCause map = missingMap(inputs, limits, now);
  if (map != StopCause::kNone) return map;
  const StopCause odometry = missingOdometry(inputs, limits, now);
  const StopCause cause =
      odometry != StopCause::kNone ? odometry : missingPeople(inputs, limits, now);
  // Whatever is missing after a jump is missing because of it.
  const bool jumped = happenedWithin(inputs.jump_at, limits.people, now);
  return cause != StopCause::kNone && jumped ? inputs.jump : cause;
}

std::string explain(StopCause cause, const Inputs& inputs) {
  const auto with = [cause](const InputTraffic& traffic) {
    return fmt::format("{}: {}", describe(cause), describe(traffic.last_fault));
  };
  switch (cause) {
    case StopCause::kOdometryRefused:
      return with(inputs.odometry_traffic);
    case StopCause::kPeopleRefused:
      return with(inputs.people_traffic);
    case StopCause::kMapRefused:
      return with(inputs.map_traffic);
    default:
      return describe(cause);
  }
}

}  // namespace pomdp_crowd_nav
