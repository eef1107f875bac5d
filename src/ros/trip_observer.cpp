// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/ros/trip_observer.h"

namespace pomdp_crowd_nav {

TripObserver::TripObserver(const Params& params, const Point& goal)
    : params_(params), goal_(goal), recorder_(params.metrics) {}

void TripObserver::begin(const Point& goal, double time) {
  goal_ = goal;
  begin_time_ = time;
  has_reached_goal_ = is_over_ = false;
  recorder_.reset();
}

void TripObserver::jump() { recorder_.jump(); }

void TripObserver::look(const Simulator& simulator) {
  if (!begin_time_ || is_over_) return;
  const SimulatedBase& base = simulator.base();
  recorder_.look(simulator.time() - *begin_time_, base.pose().position, base.velocity().norm(),
                 simulator.crowd().walkers());
}

void TripObserver::tick(const Simulator& simulator) {
  const Point& robot = simulator.base().pose().position;
  const double speed = simulator.base().velocity().norm();
  if (!begin_time_ && speed < params_.metrics.moving_speed) return;
  if (!begin_time_) begin(goal_, simulator.time() - Crowd::kTick);
  if (is_over_) return;
  recorder_.tick(simulator.time() - *begin_time_, robot, speed, simulator.crowd().walkers());
  if ((robot - goal_).norm() <= params_.goal_tolerance) has_reached_goal_ = true;
  if (has_reached_goal_) recorder_.arrive();
  is_over_ = has_reached_goal_ && speed < params_.metrics.moving_speed;
}

}  // namespace pomdp_crowd_nav
