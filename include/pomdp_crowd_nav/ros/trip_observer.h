// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "pomdp_crowd_nav/evaluation/metrics.h"
#include "pomdp_crowd_nav/sim/simulator.h"

namespace pomdp_crowd_nav {

// Measures the robot's trips from the truth of the simulator, without ROS.
//
// A trip begins with a goal, or else with the first motion. Its clock stops when the robot comes
// within the goal tolerance; people are watched until it is at rest there.
class TripObserver {
 public:
  struct Params {
    MetricsRecorder::Params metrics;
    double goal_tolerance = 1.0;  // [m]
  };

  TripObserver(const Params& params, const Point& goal);

  void begin(const Point& goal, double time);
  // The robot was put elsewhere.
  void jump();

  // At every step of the base, however short.
  void look(const Simulator& simulator);
  // Once per tick of the crowd.
  void tick(const Simulator& simulator);

  const EpisodeMetrics& metrics() const { return recorder_.metrics(); }
  bool hasReachedGoal() const { return has_reached_goal_; }

 private:
  Params params_;
  Point goal_;
  std::optional<double> begin_time_;  // [s] of the simulation
  bool has_reached_goal_ = false;
  bool is_over_ = false;  // at rest at the goal
  MetricsRecorder recorder_;
};

}  // namespace pomdp_crowd_nav
