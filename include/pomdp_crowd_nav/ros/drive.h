// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "pomdp_crowd_nav/belief/belief_tracker.h"
#include "pomdp_crowd_nav/planner/planner.h"
#include "pomdp_crowd_nav/ros/conversions.h"
#include "pomdp_crowd_nav/ros/motion_executor.h"
#include "pomdp_crowd_nav/ros/node_params.h"

namespace pomdp_crowd_nav {

// Why the base is braked or stopped while it has a goal.
enum class StopCause {
  kNone,
  kNoOdometry,
  kOdometryNotFinite,
  kNoTransform,
  kNoPeople,
  kWatchingPeople,  // beliefs need a second of tracks before they mean anything
  kNoMap,
  kJumped,  // the clock back or the robot elsewhere: beliefs began afresh
  kPreparing,
  kNoDecision,
  kEmergency,
  kObstacle,  // of a map that the planner does not know yet
  kPaused
};

const char* describe(StopCause cause);

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

// What came in, and when. All times [s], steady clock; negative: never.
struct Inputs {
  std::optional<RobotReading> robot;
  TrackList tracks;
  CrowdBelief crowd;
  double tracks_at = -1.0;        // moment at which the newest tracks were measured
  double first_tracks_at = -1.0;  // of the present, unbroken series
  std::shared_ptr<const StaticMap> map;
  double map_at = -1.0;
  double bad_odometry_at = -1.0;
  double transform_failure_at = -1.0;
  double jump_at = -1.0;  // of clock or pose
  unsigned bad_odometry = 0;
  unsigned transform_failures = 0;
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
  Inputs inputs;
  Goal goal;  // number 0: none
  std::optional<Ending> ending;
  bool paused = false;
  bool prepared = false;  // a planner of this trip stands, of its newest goal and map or of others
  long first_goal = 0;    // of the trip; those after it came while the robot was driving
  int approaches = 0;     // times the base had to go back to the goal
  std::shared_ptr<const StaticMap> planned_map;  // the planner's
  StopCause reflex_or_miss = StopCause::kNone;   // why the base brakes until the next decision
  MotionExecutor executor;
  Blocker blocker;
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

// Age limits, [s].
struct InputLimits {
  double odometry = 0.5;
  double people = 1.0;
  double map = 0.0;       // 0: none
  double watching = 1.0;  // unbroken tracks needed before the first decision
};

InputLimits inputLimits(const PlannerNodeParams& params);

// No base gets from one reading to the other; it was put elsewhere or found that it is.
bool isPoseJump(const RobotReading& from, const RobotReading& to, double max_speed);

// The first input that is missing or too old; kNone when the robot may drive.
StopCause missingInput(const Inputs& inputs, const InputLimits& limits, double now);

// Why the base does not follow a decision at the moment.
StopCause stopCause(const Drive& drive, const InputLimits& limits, double now);

// Why there is no progress.
std::string whyBlocked(const Drive& drive, StopCause cause, double now);

// All but the header.
PlannerStatus toStatus(const Drive& drive, const InputLimits& limits, double now);

}  // namespace pomdp_crowd_nav
