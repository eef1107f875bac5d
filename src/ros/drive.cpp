// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/ros/drive.h"

#include <fmt/format.h>

#include <algorithm>

namespace pomdp_crowd_nav {
namespace {

bool happenedWithin(double moment, double duration, double now) {
  return moment >= 0.0 && now - moment <= duration;
}

double age(double moment, double now) { return moment < 0.0 ? -1.0 : now - moment; }

StopCause missingOdometry(const Inputs& inputs, const InputLimits& limits, double now) {
  if (inputs.robot && now - inputs.robot->measured_at <= limits.odometry) return StopCause::kNone;
  if (happenedWithin(inputs.bad_odometry_at, limits.odometry, now)) {
    return StopCause::kOdometryNotFinite;
  }
  if (happenedWithin(inputs.transform_failure_at, limits.odometry, now)) {
    return StopCause::kNoTransform;
  }
  return StopCause::kNoOdometry;
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
  return describe(cause);
}

}  // namespace

const char* describe(StopCause cause) {
  switch (cause) {
    case StopCause::kNone:
      return "";
    case StopCause::kNoOdometry:
      return "odometry is silent or too old";
    case StopCause::kOdometryNotFinite:
      return "odometry is not finite";
    case StopCause::kNoTransform:
      return "no transform to the global frame";
    case StopCause::kNoPeople:
      return "tracked people are silent or too old";
    case StopCause::kWatchingPeople:
      return "watching people before the start";
    case StopCause::kNoMap:
      return "the map is missing or too old";
    case StopCause::kJumped:
      return "the clock or the robot's pose jumped";
    case StopCause::kPreparing:
      return "the way to the goal is being worked out";
    case StopCause::kNoDecision:
      return "no decision in time";
    case StopCause::kEmergency:
      return "emergency brake, a person is too close";
    case StopCause::kObstacle:
      return "an obstacle of the new map is in the way";
    case StopCause::kPaused:
      return "paused";
  }
  return "";
}

InputLimits inputLimits(const PlannerNodeParams& params) {
  InputLimits limits;
  limits.odometry = params.navigation.odom_timeout;
  limits.people = params.navigation.people_timeout;
  limits.map = params.map_timeout;
  return limits;
}

bool isPoseJump(const RobotReading& from, const RobotReading& to, double max_speed) {
  constexpr double kSlack = 1.0;  // [m], corrections of the localisation are smaller
  const double way = (to.pose.position - from.pose.position).norm();
  return way > max_speed * std::max(0.0, to.measured_at - from.measured_at) + kSlack;
}

StopCause missingInput(const Inputs& inputs, const InputLimits& limits, double now) {
  if (!inputs.map || (limits.map > 0.0 && now - inputs.map_at > limits.map)) {
    return StopCause::kNoMap;
  }
  const bool jumped = happenedWithin(inputs.jump_at, limits.people, now);
  const StopCause odometry = missingOdometry(inputs, limits, now);
  if (odometry != StopCause::kNone) return jumped ? StopCause::kJumped : odometry;
  if (!happenedWithin(inputs.tracks_at, limits.people, now)) {
    return jumped ? StopCause::kJumped : StopCause::kNoPeople;
  }
  if (inputs.tracks_at - inputs.first_tracks_at < limits.watching) {
    return jumped ? StopCause::kJumped : StopCause::kWatchingPeople;
  }
  return StopCause::kNone;
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

std::string whyBlocked(const Drive& drive, StopCause cause, double now) {
  const std::string stalled =
      fmt::format("no progress for {:.0f} s", drive.progress.stalledFor(now));
  if (drive.blocker.id >= 0) {
    return fmt::format("{}: person {} is in the way", stalled, drive.blocker.id);
  }
  if (cause != StopCause::kNone) return stalled + ": " + describe(cause);
  return stalled + ": no way on is found";
}

PlannerStatus toStatus(const Drive& drive, const InputLimits& limits, double now) {
  const StopCause cause = stopCause(drive, limits, now);
  PlannerStatus status;
  status.state = stateOf(drive, cause, now);
  status.state_name = nameOf(status.state);
  status.stop_cause = describeState(drive, status.state, cause, now);
  status.odom_age = drive.inputs.robot ? now - drive.inputs.robot->measured_at : -1.0;
  status.people_age = age(drive.inputs.tracks_at, now);
  status.map_age = age(drive.inputs.map_at, now);
  status.bad_odometry = drive.inputs.bad_odometry;
  status.transform_failures = drive.inputs.transform_failures;
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
