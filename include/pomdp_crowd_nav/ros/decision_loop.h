// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <thread>

#include "pomdp_crowd_nav/control/emergency_override.h"
#include "pomdp_crowd_nav/ros/decision_schedule.h"
#include "pomdp_crowd_nav/ros/drive.h"
#include "pomdp_crowd_nav/ros/guarded.h"
#include "pomdp_crowd_nav/ros/trip_planner.h"

namespace pomdp_crowd_nav {

// What a decision was made from, and what came of it.
struct DecisionReport {
  Goal goal;
  Situation situation;  // predicted to the moment at which the decision takes effect
  Pose robot;           // as measured
  Decision decision;
};

// The planning thread: for every decision step it takes the newest inputs, predicts them to the
// moment at which the decision takes effect, searches until the deadline and hands the motion to
// the executor. A decision that is late, or was overtaken by a stop, is dropped.
class DecisionLoop {
 public:
  // Both are called from the planning thread, without the lock.
  struct Callbacks {
    std::function<void(const DecisionReport&, const Planner&)> decided;
    std::function<void(const Goal&, const std::string& reason)> failed;
  };

  DecisionLoop(const PlannerNodeParams& params, Guarded<Drive>& drive, Callbacks callbacks);
  ~DecisionLoop();

 private:
  // The inputs at the start of a search.
  struct Snapshot {
    Situation situation;
    TrackList tracks;  // predicted
    Pose robot;
    long stop_count = 0;
  };

  void run();
  void prepare();
  void followParams(const TripPlanner::Params& params, const Pose& robot);
  void adoptParams(const TripPlanner::Params& params);
  std::string whyNoWayFrom(const Pose& robot) const;
  void decide(const DecisionSlot& slot);
  void giveUp(const std::string& reason);
  bool mayDrive(double now);
  void countLeftOut(const DecisionSlot& slot);
  bool sleepUntil(double time);
  std::optional<Snapshot> snapshotFor(double effect) const;
  Decision think(const Snapshot& snapshot, const DecisionSlot& slot);
  void handOver(const Snapshot& snapshot, const Decision& decision, double effect);

  PlannerNodeParams params_;
  InputLimits limits_;
  Guarded<Drive>& drive_;
  Callbacks callbacks_;
  EmergencyOverride emergency_;
  DecisionSchedule schedule_;
  bool is_driving_ = false;  // the schedule runs

  // The trip that the planner stands for.
  Goal goal_;
  std::shared_ptr<const StaticMap> map_;
  TripPlanner planner_;
  TripPlanner::Params navigation_;  // of the override and the schedule

  std::atomic<bool> stop_{false};
  std::thread thread_;
};

}  // namespace pomdp_crowd_nav
