// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "pomdp_crowd_nav/planner/planner.h"
#include "pomdp_crowd_nav/ros/inputs.h"
#include "pomdp_crowd_nav/ros/motion_executor.h"
#include "pomdp_crowd_nav/ros/node_params.h"

namespace pomdp_crowd_nav {

// How a trip ended; the names of the action's terminal states follow from it.
enum class Outcome { kReached, kCancelled, kPreempted, kFailed };

struct Goal {
  long number = 0;  // 0: none
  Pose pose;
};

// A trip that is over: what remains is to stop the base and to report.
struct Ending {
  Goal goal;
  Outcome outcome = Outcome::kReached;
  std::string text;
  double since = 0.0;  // [s]
};

// A person for whom the robot stands still.
struct Blocker {
  std::int64_t id = -1;
  double since = 0.0;  // [s]
};

// The person who was in the way last, whether the robot stood still or drove to and fro.
struct Encounter {
  std::int64_t id = -1;
  double when = 0.0;  // [s]
};

// Since the goal was accepted.
struct TripCounts {
  unsigned decisions = 0;
  unsigned deadline_misses = 0;
  unsigned sudden_brakes = 0;
  unsigned bound_violations = 0;
};

// The one thing that callbacks, planning thread and command timer share.
struct Drive {
  std::shared_ptr<const NavigationParams> params;  // the newest, see Reconfiguration
  Inputs inputs;
  Goal goal;  // number 0: none
  std::optional<Ending> ending;
  bool paused = false;
  bool closing = false;   // the node ends: no trip begins any more
  long last_goal = 0;     // number of the newest that a trip began for
  bool prepared = false;  // a planner of this trip stands, of its newest goal and map or of others
  long first_goal = 0;    // of the trip; those after it came while the robot was driving
  int approaches = 0;     // times the base had to go back to the goal
  std::shared_ptr<const StaticMap> planned_map;  // of the motion that is followed
  double planned_from = 0.0;                    // [s], that motion begins; the one before knew less
  StopCause reflex_or_miss = StopCause::kNone;  // why the base brakes until the next decision
  MotionExecutor executor;
  Blocker blocker;
  Encounter encounter;
  ProgressWatch progress;
  TripCounts counts;
  SearchStatistics search;  // of the last decision
  double cycle_time = 0.0;  // [s], of the last decision
  std::string action;       // of the last decision

  explicit Drive(const MotionExecutor& motion_executor,
                 const ProgressWatch& progress_watch = ProgressWatch())
      : executor(motion_executor), progress(progress_watch) {}

  bool hasGoal() const { return goal.number != 0; }
};

InputLimits inputLimits(const PlannerNodeParams& params);

// Why the base does not follow a decision at the moment.
StopCause stopCause(const Drive& drive, const InputLimits& limits, double now);

// Why there is no progress.
std::string whyBlocked(const Drive& drive, StopCause cause, double now);

// All but the header.
PlannerStatus toStatus(const Drive& drive, const InputLimits& limits, double now);

}  // namespace pomdp_crowd_nav
