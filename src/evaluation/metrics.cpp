// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/evaluation/metrics.h"

#include <algorithm>
#include <cmath>

namespace pomdp_crowd_nav {

void MetricsRecorder::tick(double time, const Point& robot, double speed,
                           const std::vector<Walker>& walkers) {
  if (!has_arrived_) metrics_.travel_time = time;
  metrics_.max_speed = std::max(metrics_.max_speed, speed);
  if (has_position_) metrics_.path_length += (robot - last_position_).norm();
  has_position_ = true;
  last_position_ = robot;
  const double nearest = look(time, robot, speed, walkers);
  if (nearest <= params_.risky_distance) ++metrics_.unsafe_ticks;
  if (nearest <= params_.contact_distance) ++metrics_.contact_ticks;
}

double MetricsRecorder::look(double time, const Point& robot, double speed,
                             const std::vector<Walker>& walkers) {
  double nearest = std::numeric_limits<double>::infinity();
  if (speed < params_.moving_speed) return nearest;
  for (const Walker& walker : walkers) {
    nearest = std::min(nearest, (walker.position - robot).norm());
  }
  metrics_.min_moving_distance = std::min(metrics_.min_moving_distance, nearest);
  // A tick belongs to the step during which it passed: the one that ends at or after it.
  const long step = static_cast<long>(std::ceil(time / params_.step - 1e-6));
  if (nearest < params_.unsafe_distance && step != last_unsafe_step_) {
    ++metrics_.unsafe_steps;
    last_unsafe_step_ = step;
  }
  return nearest;
}

void MetricsRecorder::countDecision(bool sudden_brake, bool missed_deadline) {
  ++metrics_.decisions;
  if (sudden_brake) ++metrics_.sudden_brakes;
  if (missed_deadline) ++metrics_.deadline_misses;
}

}  // namespace pomdp_crowd_nav
