// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/ros/command_loop.h"

#include <algorithm>
#include <cmath>

namespace pomdp_crowd_nav {
namespace {

constexpr double kRestSpeed = 0.03;     // [m/s]
constexpr double kRestYawRate = 0.05;   // [rad/s]
constexpr double kRestTime = 0.2;       // [s] of odometry at rest
constexpr double kPatience = 5.0;       // [s] for the base to stop before the trip is reported
constexpr double kTurnPatience = 15.0;  // [s] for the turn at the goal

}  // namespace

CommandLoop::CommandLoop(const PlannerNodeParams& params)
    : goal_tolerance_(params.navigation.planning.model.goal_tolerance),
      yaw_tolerance_(params.navigation.yaw_goal_tolerance),
      yaw_gain_(params.navigation.command.yaw_gain),
      period_(1.0 / params.navigation.controller_frequency),
      vehicle_(params.navigation.planning.model.vehicle),
      emergency_(params.navigation.emergency, vehicle_, params.navigation.planning.model.step) {
  limits_.odometry = params.navigation.odom_timeout;
  limits_.people = params.navigation.people_timeout;
  limits_.map = params.map_timeout;
}

CommandLoop::Tick CommandLoop::tick(double now, Drive& drive) {
  if (drive.hasGoal()) {
    last_yaw_rate_ = 0.0;
    watchInputs(now, drive);
    watchPeople(now, drive);
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
    tick.finished = drive.ending;
    drive.ending.reset();
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
  const double speed = robot.velocity.norm();
  if (speed < MotionExecutor::kRestSpeed) return;
  const VehicleState vehicle{robot.pose.position,
                             std::atan2(robot.velocity.y(), robot.velocity.x()), speed};
  TrackList tracks = drive.inputs.tracks;
  CrowdBelief nobody;
  predictPeople(now - drive.inputs.tracks_at, nobody, tracks);
  if (!emergency_.reflex(vehicle, tracks, robot.yaw_rate)) return;
  drive.executor.stop();
  drive.reflex_or_miss = StopCause::kEmergency;
  ++drive.counts.sudden_brakes;
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
  const bool still = isFresh(now, drive) && robot->velocity.norm() < kRestSpeed &&
                     std::abs(robot->yaw_rate) < kRestYawRate;
  if (!still) rest_since_ = -1.0;
  if (still && rest_since_ < 0.0) rest_since_ = now;
  return still && now - rest_since_ >= kRestTime;
}

bool CommandLoop::isOver(double now, const Drive& drive, bool at_rest) const {
  const double duration = now - drive.ending->since;
  if (at_rest && yawError(drive) == 0.0) return true;
  return duration > kPatience && (yawError(drive) == 0.0 || duration > kTurnPatience);
}

// What is left to turn at the goal [rad]; 0 when it does not matter or is near enough.
double CommandLoop::yawError(const Drive& drive) const {
  if (drive.ending->outcome != Outcome::kReached || yaw_tolerance_ >= M_PI) return 0.0;
  if (!drive.inputs.robot) return 0.0;
  const double error =
      wrapAngle(drive.ending->goal.pose.heading - drive.inputs.robot->pose.heading);
  return std::abs(error) <= yaw_tolerance_ ? 0.0 : error;
}

BaseCommand CommandLoop::turnInPlace(double yaw_error) {
  const double wanted =
      std::clamp(yaw_gain_ * yaw_error, -vehicle_.max_yaw_rate, vehicle_.max_yaw_rate);
  const double change = vehicle_.yaw_acceleration * period_;
  last_yaw_rate_ += std::clamp(wanted - last_yaw_rate_, -change, change);
  return {Point(0.0, 0.0), last_yaw_rate_};
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

}  // namespace pomdp_crowd_nav
