// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/ros/drive.h"

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

std::uint8_t stateOf(const Drive& drive, StopCause cause) {
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
      return drive.blocker.id >= 0 ? PlannerStatus::WAITING_FOR_PEOPLE : PlannerStatus::DRIVING;
    default:
      return PlannerStatus::WAITING_FOR_INPUT;
  }
}

const char* nameOf(std::uint8_t state) {
  constexpr const char* kNames[] = {"IDLE",    "PREPARING",          "WAITING_FOR_INPUT",
                                    "DRIVING", "WAITING_FOR_PEOPLE", "PAUSED",
                                    "STOPPING"};
  return kNames[state];
}

}  // namespace

StopCause stopCause(const Drive& drive, const InputLimits& limits, double now) {
  if (!drive.hasGoal()) return StopCause::kNone;
  if (drive.paused) return StopCause::kPaused;
  const StopCause input = missingInput(drive.inputs, limits, now);
  if (input != StopCause::kNone) return input;
  if (!drive.executor.isStopping(now)) return StopCause::kNone;
  if (!drive.prepared || drive.counts.decisions == 0) return StopCause::kPreparing;
  return drive.reflex_or_miss == StopCause::kNone ? StopCause::kNoDecision : drive.reflex_or_miss;
}

PlannerStatus toStatus(const Drive& drive, const InputLimits& limits, double now) {
  const StopCause cause = stopCause(drive, limits, now);
  PlannerStatus status;
  status.state = stateOf(drive, cause);
  status.state_name = nameOf(status.state);
  status.stop_cause = drive.ending ? drive.ending->text : explain(cause, drive.inputs);
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
