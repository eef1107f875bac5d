// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/ros/decision_loop.h"

#include <ros/console.h>

#include <algorithm>
#include <chrono>
#include <exception>
#include <utility>

#include "pomdp_crowd_nav/ros/steady_time.h"

namespace pomdp_crowd_nav {
namespace {

constexpr double kNap = 0.01;  // [s], how soon a new goal or a stop is noticed

void nap(double duration) {
  std::this_thread::sleep_for(std::chrono::duration<double>(std::min(duration, kNap)));
}

// The base follows a motion that minds `map`, from `effect` on.
void noteMap(std::shared_ptr<const StaticMap>& map, double effect, Drive& drive) {
  if (drive.planned_map == map) return;
  drive.planned_map.swap(map);
  drive.planned_from = effect;
}

void notePerson(const Verdict& verdict, double now, Drive& drive) {
  if (verdict.in_the_way) drive.encounter = {*verdict.in_the_way, now};
  if (!verdict.in_the_way || !verdict.stands) {
    drive.blocker = Blocker();
    return;
  }
  if (drive.blocker.id != *verdict.in_the_way) drive.blocker.since = now;
  drive.blocker.id = *verdict.in_the_way;
}

}  // namespace

DecisionLoop::DecisionLoop(const PlannerNodeParams& params, Guarded<Drive>& drive,
                           MapWork& map_work, Callbacks callbacks)
    : limits_(inputLimits(params)),
      drive_(drive),
      callbacks_(std::move(callbacks)),
      maker_(params.navigation),
      vehicle_(params.navigation.planning.model.vehicle),
      obstacles_(vehicle_, params.navigation.emergency.reaction_time),
      schedule_(params.navigation.planning.model.step, params.navigation.search_time),
      builder_(params.destinations, drive, map_work, callbacks_.failed),
      thread_([this] { run(); }) {}

DecisionLoop::~DecisionLoop() {
  stop_ = true;
  thread_.join();
}

void DecisionLoop::run() {
  while (!stop_) {
    adoptParams();
    adoptPlanner();
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

// The override and the schedule follow changed parameters at once, the planner when it is made.
void DecisionLoop::adoptParams() {
  const auto params = drive_.with([](Drive& drive) { return drive.params; });
  if (params == params_) return;
  maker_ = DecisionMaker(*params);
  schedule_.setSearchTime(params->search_time);
  obstacles_ = ObstacleReflex(vehicle_, params->emergency.reaction_time);
  params_ = params;
}

void DecisionLoop::adoptPlanner() {
  std::optional<ReadyPlanner> ready = builder_.take();
  if (!ready) return;
  present_ = std::move(*ready);
  drive_.with([&](Drive& drive) {
    if (!drive.hasGoal() || present_.goal.number < drive.first_goal) return;
    drive.prepared = true;
    drive.progress.takeAnotherWay();
  });
  callbacks_.adopted(*present_.planner);
}

void DecisionLoop::giveUp(const std::string& reason) {
  ROS_WARN("goal given up: %s", reason.c_str());
  drive_.with([](Drive& drive) { drive.prepared = false; });
  callbacks_.failed(present_.goal, "failed: " + reason);
}

bool DecisionLoop::mayDrive(double now) {
  return drive_.with([&](Drive& drive) {
    return drive.hasGoal() && drive.prepared && !drive.paused &&
           missingInput(drive.inputs, limits_, now) == StopCause::kNone;
  });
}

void DecisionLoop::countLeftOut(const DecisionSlot& slot) {
  if (slot.left_out == 0) return;
  drive_.with(
      [&](Drive& drive) { drive.counts.deadline_misses += static_cast<unsigned>(slot.left_out); });
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

std::optional<Snapshot> DecisionLoop::snapshotFor(double effect) const {
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
    const SearchLimit limit = SearchLimit::until(toSteadyTime(slot.deadline));
    const Verdict verdict = maker_.decide(*snapshot, limit, *present_.planner);
    handOver(*snapshot, verdict, slot.effect);
    callbacks_.decided({present_.goal, snapshot->situation, snapshot->robot, verdict.decision},
                       *present_.planner);
  } catch (const std::exception& error) {
    giveUp(error.what());
  }
}

void DecisionLoop::handOver(const Snapshot& snapshot, const Verdict& verdict, double effect) {
  const Decision& decision = verdict.decision;
  auto known_map = present_.map;  // swapped, so that a map that goes does so with the lock open
  drive_.with([&](Drive& drive) {
    const double now = steadySeconds();
    const bool was_stopped = drive.executor.stopCount() != snapshot.stop_count;
    const bool is_moving = snapshot.situation.vehicle.speed > 0.0;
    if (!drive.hasGoal() || !drive.prepared) return;
    ++drive.counts.decisions;
    drive.counts.bound_violations += static_cast<unsigned>(decision.search.bound_violations);
    drive.search = decision.search;
    drive.cycle_time = decision.wall_time;
    drive.action = describe(decision.action);
    if (now > effect) {
      ++drive.counts.deadline_misses;
      drive.reflex_or_miss = StopCause::kNoDecision;
    } else if (!was_stopped) {
      if (decision.action.sudden_brake && is_moving) ++drive.counts.sudden_brakes;
      if (follow(decision.motion, effect, drive)) noteMap(known_map, effect, drive);
    }
    drive.progress.see(verdict.way, now);
    notePerson(verdict, now, drive);
  });
}

// Unless it leads into an obstacle of a map that the planner does not know.
bool DecisionLoop::follow(const StepMotion& motion, double effect, Drive& drive) const {
  const bool is_planned = drive.inputs.map == present_.map;
  if (!is_planned && drive.inputs.map && obstacles_.hits(motion, *drive.inputs.map)) {
    drive.executor.stop();
    drive.reflex_or_miss = StopCause::kObstacle;
    return false;
  }
  drive.executor.follow(motion, effect);
  drive.reflex_or_miss = StopCause::kNone;
  return true;
}

}  // namespace pomdp_crowd_nav
