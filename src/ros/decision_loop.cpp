// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/ros/decision_loop.h"

#include <ros/console.h>

#include <algorithm>
#include <chrono>
#include <stdexcept>
#include <tuple>

#include "pomdp_crowd_nav/evaluation/reachability.h"
#include "pomdp_crowd_nav/planner/planner_factory.h"
#include "pomdp_crowd_nav/ros/steady_time.h"

namespace pomdp_crowd_nav {
namespace {

constexpr double kNap = 0.01;  // [s], how soon a new goal or a stop is noticed

void nap(double duration) {
  std::this_thread::sleep_for(std::chrono::duration<double>(std::min(duration, kNap)));
}

InputLimits limitsOf(const PlannerNodeParams& params) {
  InputLimits limits;
  limits.odometry = params.navigation.odom_timeout;
  limits.people = params.navigation.people_timeout;
  limits.map = params.map_timeout;
  return limits;
}

// The nearest person to a robot that does not move and is not going to.
std::optional<std::int64_t> findBlocker(const Situation& situation, const TrackList& tracks,
                                        const Decision& decision) {
  const bool stands = situation.vehicle.speed <= 0.0 && decision.motion.end_velocity.norm() <= 0.0;
  if (!stands || tracks.tracks.empty()) return std::nullopt;
  const auto distance = [&](const Track& track) {
    return (track.position - situation.vehicle.position).squaredNorm();
  };
  return std::min_element(tracks.tracks.begin(), tracks.tracks.end(),
                          [&](const Track& a, const Track& b) { return distance(a) < distance(b); })
      ->id;
}

void noteBlocker(const std::optional<std::int64_t>& blocker, double now, Drive& drive) {
  if (!blocker) {
    drive.blocker = Blocker();
    return;
  }
  if (drive.blocker.id < 0) drive.blocker.since = now;
  drive.blocker.id = *blocker;
}

}  // namespace

DecisionLoop::DecisionLoop(const PlannerNodeParams& params, Guarded<Drive>& drive,
                           Callbacks callbacks)
    : params_(params),
      limits_(limitsOf(params)),
      drive_(drive),
      callbacks_(std::move(callbacks)),
      emergency_(params.navigation.emergency, params.navigation.planning.model.vehicle,
                 params.navigation.planning.model.step),
      schedule_(params.navigation.planning.model.step, params.navigation.search_time),
      thread_([this] { run(); }) {}

DecisionLoop::~DecisionLoop() {
  stop_ = true;
  thread_.join();
}

void DecisionLoop::run() {
  while (!stop_) {
    prepare();
    const double now = steadySeconds();
    if (!mayDrive(now)) {
      is_driving_ = false;
      nap(kNap);
      continue;
    }
    if (!is_driving_) schedule_.restart(now);
    is_driving_ = true;
    const DecisionSlot slot = schedule_.next(now);
    countLeftOut(slot);
    if (sleepUntil(slot.start)) decide(slot);
  }
}

// Builds the planner when the goal or the map is another one, and looks for a way.
void DecisionLoop::prepare() {
  const auto [goal, map, robot] = drive_.with([](Drive& drive) {
    return std::make_tuple(drive.goal, drive.inputs.map, drive.inputs.robot);
  });
  const bool stands = goal.number == goal_.number && map == map_;
  if (goal.number == 0 || !map || !robot || stands) return;
  goal_ = goal;
  map_ = map;
  planner_.reset();
  drive_.with([](Drive& drive) { drive.prepared = false; });
  try {
    const Task task{*map, goal.pose.position, params_.destinations};
    planner_ = makePlanner(params_.navigation.planner, task, params_.navigation.planning);
    const std::string no_way = whyNoWay(*planner_, {robot->pose.position, goal.pose.position}, *map,
                                        params_.navigation.planning.model);
    if (!no_way.empty()) return giveUp(no_way);
  } catch (const std::exception& error) {
    return giveUp(error.what());
  }
  drive_.with([&](Drive& drive) { drive.prepared = drive.goal.number == goal.number; });
  is_driving_ = false;
}

void DecisionLoop::giveUp(const std::string& reason) {
  ROS_WARN("goal given up: %s", reason.c_str());
  callbacks_.failed(goal_, reason);
}

bool DecisionLoop::mayDrive(double now) {
  return drive_.with([&](Drive& drive) {
    return drive.goal.number == goal_.number && drive.prepared && !drive.paused &&
           missingInput(drive.inputs, limits_, now) == StopCause::kNone;
  });
}

void DecisionLoop::countLeftOut(const DecisionSlot& slot) {
  if (slot.left_out == 0) return;
  drive_.with([&](Drive& drive) {
    if (drive.goal.number != goal_.number) return;
    drive.counts.deadline_misses += static_cast<unsigned>(slot.left_out);
  });
}

// False when the trip was stopped meanwhile.
bool DecisionLoop::sleepUntil(double time) {
  while (!stop_) {
    const double now = steadySeconds();
    if (now >= time) return mayDrive(now);
    if (!mayDrive(now)) return false;
    nap(time - now);
  }
  return false;
}

std::optional<DecisionLoop::Snapshot> DecisionLoop::snapshotFor(double effect) const {
  Snapshot snapshot;
  double tracks_at = 0.0;
  const bool is_complete = drive_.with([&](Drive& drive) {
    if (!drive.inputs.robot) return false;
    snapshot.situation.vehicle = drive.executor.predict(*drive.inputs.robot, effect);
    snapshot.situation.crowd = drive.inputs.crowd;
    snapshot.tracks = drive.inputs.tracks;
    snapshot.robot = drive.inputs.robot->pose;
    snapshot.stop_count = drive.executor.stopCount();
    tracks_at = drive.inputs.tracks_at;
    return true;
  });
  if (!is_complete) return std::nullopt;
  predictPeople(effect - tracks_at, snapshot.situation.crowd, snapshot.tracks);
  return snapshot;
}

void DecisionLoop::decide(const DecisionSlot& slot) {
  const std::optional<Snapshot> snapshot = snapshotFor(slot.effect);
  if (!snapshot) return;
  try {
    const Decision decision = think(*snapshot, slot);
    handOver(*snapshot, decision, slot.effect);
    callbacks_.decided({goal_, snapshot->situation, snapshot->robot, decision}, *planner_);
  } catch (const std::exception& error) {
    giveUp(error.what());
  }
}

Decision DecisionLoop::think(const Snapshot& snapshot, const DecisionSlot& slot) {
  Decision decision =
      planner_->decide(snapshot.situation, SearchLimit::until(toSteadyTime(slot.deadline)));
  const VehicleState& vehicle = snapshot.situation.vehicle;
  if (const auto action = emergency_.replace(vehicle, snapshot.tracks)) {
    emergency_.apply(*action, vehicle, decision);
  }
  return decision;
}

void DecisionLoop::handOver(const Snapshot& snapshot, const Decision& decision, double effect) {
  drive_.with([&](Drive& drive) {
    const double now = steadySeconds();
    const bool is_late = now > effect;
    const bool was_stopped = drive.executor.stopCount() != snapshot.stop_count;
    const bool is_moving = snapshot.situation.vehicle.speed > 0.0;
    if (drive.goal.number != goal_.number) return;
    ++drive.counts.decisions;
    drive.counts.bound_violations += static_cast<unsigned>(decision.search.bound_violations);
    drive.search = decision.search;
    drive.cycle_time = decision.wall_time;
    drive.action = describe(decision.action);
    if (is_late) {
      ++drive.counts.deadline_misses;
      drive.reflex_or_miss = StopCause::kNoDecision;
    } else if (!was_stopped) {
      drive.executor.follow(decision.motion, effect);
      drive.reflex_or_miss = StopCause::kNone;
      if (decision.action.sudden_brake && is_moving) ++drive.counts.sudden_brakes;
    }
    noteBlocker(findBlocker(snapshot.situation, snapshot.tracks, decision), now, drive);
  });
}

}  // namespace pomdp_crowd_nav
