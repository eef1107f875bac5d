// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <vector>

#include "pomdp_crowd_nav/sim/crowd.h"

namespace pomdp_crowd_nav {

// What is counted of one trip, from the truth of the simulator at every tick.
struct EpisodeMetrics {
  double travel_time = 0.0;  // [s]
  double path_length = 0.0;  // [m]
  // [m], smallest distance to a person while the robot moved; infinite if nobody came near
  double min_moving_distance = std::numeric_limits<double>::infinity();
  int unsafe_steps = 0;   // decision steps with the moving robot within 1 m of a person (paper)
  int unsafe_ticks = 0;   // ticks with the moving robot within 0.5 m (the authors' code)
  int contact_ticks = 0;  // ticks with the moving robot within the contact distance
  int sudden_brakes = 0;
  int decisions = 0;
  int deadline_misses = 0;
  double max_speed = 0.0;  // [m/s]
};

// Measures an episode tick by tick.
class MetricsRecorder {
 public:
  struct Params {
    double step = 1.0;              // [s], decision period
    double unsafe_distance = 1.0;   // [m]
    double risky_distance = 0.5;    // [m]
    double contact_distance = 0.6;  // [m]
    double moving_speed = 0.05;     // [m/s], slower counts as at rest
  };

  explicit MetricsRecorder(const Params& params) : params_(params) {}

  void reset() { *this = MetricsRecorder(params_); }

  // One tick of the simulator that ended at `time` seconds since the trip began.
  void tick(double time, const Point& robot, double speed, const std::vector<Walker>& walkers);
  // Between ticks: counts unsafe steps and the smallest distance alone. Returns the distance to the
  // nearest person [m], infinite for a robot at rest.
  double look(double time, const Point& robot, double speed, const std::vector<Walker>& walkers);
  // The robot was put elsewhere: it has not driven there.
  void jump() { has_position_ = false; }
  // The robot is at the goal: the travel time stands still, everything else goes on.
  void arrive() { has_arrived_ = true; }
  void countReflex() { ++metrics_.sudden_brakes; }
  void countDecision(bool sudden_brake, bool missed_deadline);

  const EpisodeMetrics& metrics() const { return metrics_; }

 private:
  Params params_;
  EpisodeMetrics metrics_;
  bool has_arrived_ = false;
  bool has_position_ = false;
  Point last_position_{0.0, 0.0};
  long last_unsafe_step_ = -1;
};

}  // namespace pomdp_crowd_nav
