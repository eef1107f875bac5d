// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <functional>
#include <optional>
#include <string>
#include <thread>

#include "pomdp_crowd_nav/control/obstacle_reflex.h"
#include "pomdp_crowd_nav/ros/decision_maker.h"
#include "pomdp_crowd_nav/ros/decision_schedule.h"
#include "pomdp_crowd_nav/ros/drive.h"
#include "pomdp_crowd_nav/ros/guarded.h"
#include "pomdp_crowd_nav/ros/planner_builder.h"

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
//
// The planner is swapped between two decisions: after a newer goal or map, the trip goes on with
// the last planner until the new one stands.
class DecisionLoop {
 public:
  // Called without the lock: `decided` and `adopted`, with the planner that decides from now on,
  // from the planning thread, `failed` from any.
  struct Callbacks {
    std::function<void(const DecisionReport&, const Planner&)> decided;
    std::function<void(const Goal&, const std::string& reason)> failed;
    std::function<void(const Planner&)> adopted;
  };

  DecisionLoop(const PlannerNodeParams& params, Guarded<Drive>& drive, MapWork& map_work,
               Callbacks callbacks);
  ~DecisionLoop();

 private:
  void run();
  void adoptParams();
  void adoptPlanner();
  void decide(const DecisionSlot& slot);
  void giveUp(const std::string& reason);
  bool mayDrive(double now);
  void countLeftOut(const DecisionSlot& slot);
  bool sleepUntil(double time);
  std::optional<Snapshot> snapshotFor(double effect) const;
  void handOver(const Snapshot& snapshot, const Verdict& verdict, double effect);
  bool follow(const StepMotion& motion, double effect, Drive& drive) const;

  InputLimits limits_;
  Guarded<Drive>& drive_;
  Callbacks callbacks_;
  DecisionMaker maker_;
  VehicleParams vehicle_;
  ObstacleReflex obstacles_;
  DecisionSchedule schedule_;
  bool is_driving_ = false;  // the schedule runs

  std::shared_ptr<const NavigationParams> params_;  // of maker and schedule
  ReadyPlanner present_;                            // decides; empty before the first one
  PlannerBuilder builder_;

  std::atomic<bool> stop_{false};
  std::thread thread_;
};

}  // namespace pomdp_crowd_nav
