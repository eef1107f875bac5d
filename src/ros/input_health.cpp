// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/ros/input_health.h"

#include <fmt/format.h>

namespace pomdp_crowd_nav {
namespace {

using Level = InputHealth::Level;

constexpr double kLately = 5.0;  // [s], for so long a refused message is worth a warning

bool isOfTransform(MessageFault fault) {
  return fault == MessageFault::kNoFrameName || fault == MessageFault::kNoTransform ||
         fault == MessageFault::kOldTransform || fault == MessageFault::kBadTransform;
}

bool wasRefusedWithin(const InputTraffic& traffic, double duration, double now) {
  return traffic.refused_at >= 0.0 && now - traffic.refused_at <= duration;
}

double ageOf(double moment, double now) { return moment < 0.0 ? -1.0 : now - moment; }

// Level and text follow from what is missing.
void judge(StopCause cause, const Inputs& inputs, InputHealth& health) {
  if (cause == StopCause::kNone) {
    health.text = "fresh";
    return;
  }
  health.level = cause == StopCause::kWatchingPeople ? Level::kWarning : Level::kError;
  health.text = explain(cause, inputs);
}

InputHealth ofTopic(const char* name, const InputTraffic& traffic, double now) {
  InputHealth health;
  health.name = name;
  health.topic = traffic.topic;
  health.frame = traffic.frame;
  health.rate = traffic.rate.rate(now);
  health.refused = traffic.refusals();
  health.last_fault = describe(traffic.last_fault);
  return health;
}

void warnOfRefusals(const InputTraffic& traffic, double now, InputHealth& health) {
  if (health.level != Level::kOk || !wasRefusedWithin(traffic, kLately, now)) return;
  health.level = Level::kWarning;
  health.text = fmt::format("fresh, but some are refused: {}", describe(traffic.last_fault));
}

InputHealth transformHealth(const Inputs& inputs, const InputLimits& limits, double now) {
  InputHealth health;
  health.name = "transforms";
  health.text = "to the global frame there are";
  for (const InputTraffic* traffic : {&inputs.people_traffic, &inputs.odometry_traffic}) {
    for (int i = 0; i < kMessageFaults; ++i) {
      const auto fault = static_cast<MessageFault>(i);
      if (isOfTransform(fault)) health.refused += traffic->count(fault);
    }
    if (!isOfTransform(traffic->last_fault)) continue;
    health.last_fault = describe(traffic->last_fault);
    if (!wasRefusedWithin(*traffic, limits.people, now)) continue;
    health.level = Level::kError;
    health.frame = traffic->frame;
    health.text = fmt::format("from '{}': {}", traffic->frame, health.last_fault);
  }
  return health;
}

InputHealth clockHealth(const Inputs& inputs, const InputLimits& limits, double now) {
  InputHealth health;
  health.name = "clock";
  health.age = ageOf(inputs.clock_at, now);
  health.limit = limits.clock;
  judge(missingClock(inputs, limits, now), inputs, health);
  if (health.level == Level::kOk) health.text = "moves on";
  return health;
}

}  // namespace

std::vector<InputHealth> inputHealth(const Inputs& inputs, const InputLimits& limits, double now) {
  InputHealth odometry = ofTopic(kInputNames[0], inputs.odometry_traffic, now);
  odometry.age = inputs.robot ? now - inputs.robot->measured_at : -1.0;
  odometry.limit = limits.odometry;
  judge(missingOdometry(inputs, limits, now), inputs, odometry);
  warnOfRefusals(inputs.odometry_traffic, now, odometry);

  InputHealth people = ofTopic(kInputNames[1], inputs.people_traffic, now);
  people.age = ageOf(inputs.tracks_at, now);
  people.limit = limits.people;
  judge(missingPeople(inputs, limits, now), inputs, people);
  warnOfRefusals(inputs.people_traffic, now, people);

  InputHealth map = ofTopic(kInputNames[2], inputs.map_traffic, now);
  map.age = ageOf(inputs.map_at, now);
  map.limit = limits.map;
  judge(missingMap(inputs, limits, now), inputs, map);
  warnOfRefusals(inputs.map_traffic, now, map);

  return {odometry, people, map, transformHealth(inputs, limits, now),
          clockHealth(inputs, limits, now)};
}

}  // namespace pomdp_crowd_nav
