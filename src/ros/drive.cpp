// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/ros/drive.h"

#include <fmt/format.h>

namespace pomdp_crowd_nav {
namespace {

double age(double moment, double now) { return moment < 0.0 ? -1.0 : now - moment; }

// Messages of all inputs that were refused for one reason.
unsigned refused(const Inputs& inputs, MessageFault fault) {
  return inputs.odometry_traffic.count(fault) + inputs.people_traffic.count(fault) +
         inputs.map_traffic.count(fault);
}

void reportInputs(const Inputs& inputs, double now, PlannerStatus& status) {
  status.odom_age = inputs.robot ? now - inputs.robot->measured_at : -1.0;
  status.people_age = age(inputs.tracks_at, now);
  status.map_age = age(inputs.map_at, now);
  status.clock_age = age(inputs.clock_at, now);
  status.clock_jumps = inputs.clock_jumps;
  status.bad_odometry = inputs.odometry_traffic.count(MessageFault::kNotFinite) +
                        inputs.odometry_traffic.count(MessageFault::kOutOfRange);
  status.transform_failures =
      refused(inputs, MessageFault::kNoFrameName) + refused(inputs, MessageFault::kNoTransform) +
      refused(inputs, MessageFault::kOldTransform) + refused(inputs, MessageFault::kBadTransform);
  status.future_stamps = refused(inputs, MessageFault::kFuture);
  status.missing_stamps = refused(inputs, MessageFault::kUnstamped);
  status.out_of_order = refused(inputs, MessageFault::kOutOfOrder);
  status.people_topic = inputs.people_traffic.topic;
  status.people = static_cast<std::uint32_t>(inputs.tracks.tracks.size());
  status.bad_people = inputs.left_out.bad;
  status.duplicate_ids = inputs.left_out.duplicates;
  status.surplus_people = inputs.left_out.surplus;
}

std::uint8_t stateOf(const Drive& drive, StopCause cause, double now) {
  if (drive.ending) return PlannerStatus::STOPPING;
  if (!drive.hasGoal()) return drive.paused ? PlannerStatus::PAUSED : PlannerStatus::IDLE;
  switch (cause) {
    case StopCause::kPaused:
      return PlannerStatus::PAUSED;
    case StopCause::kPreparing:
      return PlannerStatus::PREPARING;
    case StopCause::kNone:
    case StopCause::kNoDecision:
    case StopCause::kEmergency:
    case StopCause::kObstacle:
      if (drive.progress.isBlocked(now)) return PlannerStatus::BLOCKED;
      return drive.blocker.id >= 0 ? PlannerStatus::WAITING_FOR_PEOPLE : PlannerStatus::DRIVING;
    default:
      return PlannerStatus::WAITING_FOR_INPUT;
  }
}

const char* nameOf(std::uint8_t state) {
  constexpr const char* kNames[] = {
      "IDLE",     "PREPARING", "WAITING_FOR_INPUT", "DRIVING", "WAITING_FOR_PEOPLE", "PAUSED",
      "STOPPING", "BLOCKED"};
  return kNames[state];
}

// Empty while the robot drives.
std::string describeState(const Drive& drive, std::uint8_t state, StopCause cause, double now) {
  if (drive.ending) return drive.ending->text;
  if (state == PlannerStatus::BLOCKED) return whyBlocked(drive, cause, now);
  if (state == PlannerStatus::WAITING_FOR_PEOPLE && cause == StopCause::kNone) {
    return fmt::format("person {} is in the way since {:.1f} s", drive.blocker.id,
                       now - drive.blocker.since);
  }
  return explain(cause, drive.inputs);
}

}  // namespace

InputLimits inputLimits(const PlannerNodeParams& params) {
  InputLimits limits;
  limits.odometry = params.navigation.odom_timeout;
  limits.people = params.navigation.people_timeout;
  limits.map = params.map_timeout;
  return limits;
}

StopCause stopCause(const Drive& drive, const InputLimits& limits, double now) {
  if (!drive.hasGoal()) return StopCause::kNone;
  if (drive.paused) return StopCause::kPaused;
  const StopCause input = missingInput(drive.inputs, limits, now);
  if (input != StopCause::kNone) return input;
  if (!drive.executor.isStopping(now)) return StopCause::kNone;
  if (!drive.prepared || drive.counts.decisions == 0) return StopCause::kPreparing;
  return drive.reflex_or_miss == StopCause::kNone ? StopCause::kNoDecision : drive.reflex_or_miss;
}

// Who was met lately may be why the robot drives to and fro.
std::string whyBlocked(const Drive& drive, StopCause cause, double now) {
  constexpr double kLately = 5.0;  // [s]
  const std::string stalled =
      fmt::format("no progress for {:.0f} s", drive.progress.stalledFor(now));
  const auto inTheWay = [&](std::int64_t person) {
    return fmt::format("{}: person {} is in the way", stalled, person);
  };
  if (drive.blocker.id >= 0) return inTheWay(drive.blocker.id);
  if (cause != StopCause::kNone) return stalled + ": " + explain(cause, drive.inputs);
  if (drive.encounter.id >= 0 && now - drive.encounter.when <= kLately) {
    return inTheWay(drive.encounter.id);
  }
  return stalled + ": no way on is found";
}

PlannerStatus toStatus(const Drive& drive, const InputLimits& limits, double now) {
  const StopCause cause = stopCause(drive, limits, now);
  PlannerStatus status;
  status.state = stateOf(drive, cause, now);
  status.state_name = nameOf(status.state);
  status.stop_cause = describeState(drive, status.state, cause, now);
  reportInputs(drive.inputs, now, status);
  status.cycle_time = drive.cycle_time;
  status.trials = static_cast<std::uint32_t>(drive.search.trials);
  status.tree_size = static_cast<std::uint32_t>(drive.search.belief_nodes);
  status.lower_bound = drive.search.lower_bound;
  status.upper_bound = drive.search.upper_bound;
  status.action = drive.action;
  status.decisions = drive.counts.decisions;
  status.deadline_misses = drive.counts.deadline_misses;
  status.sudden_brakes = drive.counts.sudden_brakes;
  status.bound_violations = drive.counts.bound_violations;
  status.blocking_person = drive.blocker.id;
  status.blocked_for = drive.blocker.id < 0 ? 0.0 : now - drive.blocker.since;
  return status;
}

}  // namespace pomdp_crowd_nav
