// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/ros/command_loop.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace pomdp_crowd_nav {
namespace {

constexpr double kRestTime = 0.2;       // [s] of odometry at rest
constexpr double kPatience = 5.0;       // [s] for the base to stop before the trip is reported
constexpr double kTurnPatience = 15.0;  // [s] the same where it has to turn at the goal
constexpr double kOvershoot = 0.05;     // [m] beyond the tolerance that is let pass
constexpr int kMostApproaches = 3;      // of a base that comes to rest beyond it

// From the base to the goal of a trip that ends [m].
double distanceToEnd(const Drive& drive) {
  return (drive.inputs.robot->pose.position - drive.ending->goal.pose.position).norm();
}

VehicleState stateOf(const RobotReading& robot) {
  return {robot.pose.position, std::atan2(robot.velocity.y(), robot.velocity.x()),
          robot.velocity.norm()};
}

}  // namespace

CommandLoop::CommandLoop(const PlannerNodeParams& params)
    : limits_(inputLimits(params)),
      goal_tolerance_(params.navigation.planning.model.goal_tolerance),
      yaw_tolerance_(params.navigation.yaw_goal_tolerance),
      yaw_gain_(params.navigation.command.yaw_gain),
      stopped_speed_(params.navigation.trans_stopped_vel),
      stopped_yaw_rate_(params.navigation.rot_stopped_vel),
      period_(1.0 / params.navigation.controller_frequency),
      vehicle_(params.navigation.planning.model.vehicle),
      emergency_(params.navigation.emergency, vehicle_, params.navigation.planning.model.step),
      obstacles_(vehicle_, params.navigation.emergency.reaction_time + period_) {}

void CommandLoop::setParams(const NavigationParams& params) {
  obstacles_ = ObstacleReflex(vehicle_, params.emergency.reaction_time + period_);
  emergency_ = EmergencyOverride(params.emergency, vehicle_, params.planning.model.step);
}

CommandLoop::Tick CommandLoop::tick(double now, Drive& drive) {
  if (drive.hasGoal()) {
    last_yaw_rate_ = 0.0;
    watchInputs(now, drive);
    watchPeople(now, drive);
    watchMap(now, drive);
    watchProgress(now, drive);
    if (hasReachedGoal(drive)) endTrip(Outcome::kReached, "goal reached", now, drive);
  }
  Tick tick;
  const bool at_rest = isAtRest(now, drive);
  if (drive.hasGoal() || drive.ending) resting_ = false;
  if (resting_) return tick;
  const RobotReading unknown;
  tick.command = drive.executor.commandAt(now, drive.inputs.robot.value_or(unknown));
  if (!drive.ending) {
    resting_ = !drive.hasGoal() && at_rest;
    return tick;
  }
  const double yaw_error = yawError(drive);
  if (drive.paused && yaw_error != 0.0) drive.ending->since = now;  // a pause costs no patience
  if (isOver(now, drive, at_rest)) {
    finish(now, drive, at_rest, tick);
    last_yaw_rate_ = 0.0;
  } else if (isFresh(now, drive) && (at_rest || last_yaw_rate_ != 0.0)) {
    tick.command = turnInPlace(drive.paused ? 0.0 : yaw_error);
  }
  return tick;
}

void CommandLoop::watchInputs(double now, Drive& drive) const {
  const bool must_stop =
      drive.paused || missingInput(drive.inputs, limits_, now) != StopCause::kNone;
  if (must_stop && !drive.executor.isStopping(now)) drive.executor.stop();
}

void CommandLoop::watchPeople(double now, Drive& drive) const {
  if (!drive.inputs.robot || drive.executor.isStopping(now)) return;
  const RobotReading& robot = *drive.inputs.robot;
  const VehicleState vehicle = stateOf(robot);
  if (vehicle.speed < MotionExecutor::kRestSpeed) return;
  TrackList tracks = drive.inputs.tracks;
  CrowdBelief nobody;
  predictPeople(now - drive.inputs.tracks_at, nobody, tracks);
  if (!emergency_.reflex(vehicle, tracks, robot.yaw_rate)) return;
  drive.executor.stop();
  drive.reflex_or_miss = StopCause::kEmergency;
  ++drive.counts.sudden_brakes;
}

// The planner minds the obstacles of its own map; those of a newer one are minded here until the
// base follows the first motion of the planner for that.
void CommandLoop::watchMap(double now, Drive& drive) const {
  const Inputs& inputs = drive.inputs;
  const bool knows_map = drive.planned_map == inputs.map && now >= drive.planned_from;
  const bool is_planned = !drive.planned_map || knows_map;
  if (is_planned || !inputs.map || !inputs.robot || drive.executor.isStopping(now)) return;
  if (!obstacles_.mustBrake(stateOf(*inputs.robot), *inputs.map)) return;
  drive.executor.stop();
  drive.reflex_or_miss = StopCause::kObstacle;
}

void CommandLoop::watchProgress(double now, Drive& drive) const {
  const StopCause cause = stopCause(drive, limits_, now);
  const bool is_free = cause == StopCause::kNone || cause == StopCause::kNoDecision ||
                       cause == StopCause::kEmergency || cause == StopCause::kObstacle;
  if (!is_free) drive.progress.hold(now);
  if (!drive.progress.isHopeless(now)) return;
  endTrip(Outcome::kFailed, "blocked: " + whyBlocked(drive, cause, now), now, drive);
}

bool CommandLoop::hasReachedGoal(const Drive& drive) const {
  if (!drive.inputs.robot || !drive.prepared) return false;
  return (drive.inputs.robot->pose.position - drive.goal.pose.position).norm() <= goal_tolerance_;
}

bool CommandLoop::isFresh(double now, const Drive& drive) const {
  return drive.inputs.robot && now - drive.inputs.robot->measured_at <= limits_.odometry;
}

bool CommandLoop::isAtRest(double now, const Drive& drive) {
  const std::optional<RobotReading>& robot = drive.inputs.robot;
  const bool still = isFresh(now, drive) && robot->velocity.norm() < stopped_speed_ &&
                     std::abs(robot->yaw_rate) < stopped_yaw_rate_;
  if (!still) rest_since_ = -1.0;
  if (still && rest_since_ < 0.0) rest_since_ = now;
  return still && now - rest_since_ >= kRestTime;
}

bool CommandLoop::isOver(double now, const Drive& drive, bool at_rest) const {
  if (at_rest && yawError(drive) == 0.0) return true;
  const bool turns = drive.ending->outcome == Outcome::kReached && yaw_tolerance_ < M_PI;
  return now - drive.ending->since > (turns ? kTurnPatience : kPatience);
}

// What is left to turn at the goal [rad]; 0 when it does not matter or is near enough.
double CommandLoop::yawError(const Drive& drive) const {
  if (drive.ending->outcome != Outcome::kReached || yaw_tolerance_ >= M_PI) return 0.0;
  if (!drive.inputs.robot) return 0.0;
  const double error =
      wrapAngle(drive.ending->goal.pose.heading - drive.inputs.robot->pose.heading);
  return std::abs(error) <= yaw_tolerance_ ? 0.0 : error;
}

bool CommandLoop::isPastGoal(const Drive& drive) const {
  return distanceToEnd(drive) > goal_tolerance_ + kOvershoot;
}

// What a trip lacks that ends because its goal was reached; empty when nothing.
std::string CommandLoop::whyNotReached(double now, const Drive& drive, bool at_rest) const {
  if (drive.ending->outcome != Outcome::kReached) return "";
  const char* const kNoRest = "the base does not rest at the goal";
  if (!isFresh(now, drive)) return fmt::format("{}: {}", kNoRest, describe(StopCause::kNoOdometry));
  if (at_rest && isPastGoal(drive)) {
    return fmt::format("the base rests {:.2f} m from the goal", distanceToEnd(drive));
  }
  const double yaw_error = yawError(drive);
  const bool is_rolling = drive.inputs.robot->velocity.norm() >= stopped_speed_;
  if (yaw_error != 0.0 && !is_rolling) {
    return fmt::format("the base is {:.2f} rad off the heading of the goal", std::abs(yaw_error));
  }
  return at_rest ? "" : kNoRest;
}

// A base that rolled past the goal goes on with the trip.
void CommandLoop::finish(double now, Drive& drive, bool at_rest, Tick& tick) const {
  Ending ending = *drive.ending;
  const std::string shortcoming = whyNotReached(now, drive, at_rest);
  const bool is_past = !shortcoming.empty() && at_rest && isPastGoal(drive);
  drive.ending.reset();
  if (is_past && ++drive.approaches <= kMostApproaches) {
    drive.goal = ending.goal;
    drive.prepared = true;
    return;
  }
  if (!shortcoming.empty()) {
    ending.outcome = Outcome::kFailed;
    ending.text = "failed: " + shortcoming;
  }
  tick.finished = ending;
}

BaseCommand CommandLoop::turnInPlace(double yaw_error) {
  const double wanted =
      std::clamp(yaw_gain_ * yaw_error, -vehicle_.max_yaw_rate, vehicle_.max_yaw_rate);
  const double change = vehicle_.yaw_acceleration * period_;
  last_yaw_rate_ += std::clamp(wanted - last_yaw_rate_, -change, change);
  return {Point(0.0, 0.0), last_yaw_rate_};
}

bool beginTrip(const Goal& goal, double now, Drive& drive) {
  if (drive.closing || goal.number < drive.last_goal) return false;
  drive.ending.reset();
  if (!drive.hasGoal()) {
    drive.prepared = false;
    drive.first_goal = goal.number;
  }
  drive.goal = goal;
  drive.last_goal = goal.number;
  drive.approaches = 0;
  drive.progress.begin(now);
  drive.blocker = Blocker();
  drive.encounter = Encounter();
  drive.counts = TripCounts();
  drive.search = SearchStatistics();
  return true;
}

void endTrip(Outcome outcome, const std::string& text, double now, Drive& drive) {
  if (!drive.hasGoal()) return;
  drive.ending = Ending{drive.goal, outcome, text, now};
  drive.goal = Goal();
  drive.prepared = false;
  drive.blocker = Blocker();
  drive.executor.stop();
}

void cancelTrip(double now, Drive& drive) {
  const char* const text = "cancelled";
  if (drive.ending && drive.ending->outcome == Outcome::kReached) {
    drive.ending->outcome = Outcome::kCancelled;
    drive.ending->text = text;
  }
  endTrip(Outcome::kCancelled, text, now, drive);
}

void cancelTrip(long number, double now, Drive& drive) {
  const bool is_present = drive.hasGoal() && drive.goal.number == number;
  const bool is_ending = drive.ending && drive.ending->goal.number == number;
  if (is_present || is_ending) cancelTrip(now, drive);
}

}  // namespace pomdp_crowd_nav
