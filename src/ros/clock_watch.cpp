// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/ros/clock_watch.h"

#include <ros/time.h>

#include <utility>

#include "pomdp_crowd_nav/ros/steady_time.h"

namespace pomdp_crowd_nav {

ClockWatch::ClockWatch(Clock ros_time, Clock steady)
    : clock_(std::move(ros_time)),
      steady_(std::move(steady)),
      moved_at_(steady_()),
      moved_before_(moved_at_) {}

ClockWatch::ClockWatch() : ClockWatch([] { return ros::Time::now().toSec(); }, steadySeconds) {}

// ROS time was read some time between `before` and `now`. Simulated time may stand while the
// machine is busy, and then makes up for it: what counts is when it moved on last.
ClockWatch::Look ClockWatch::look() {
  const std::lock_guard<std::mutex> lock(mutex_);
  const double before = steady_();
  const double ros_time = clock_();
  const double now = steady_();
  Look look;
  const double elapsed = now - moved_before_;
  const bool is_first = ros_time_ <= 0.0;
  const bool is_back = ros_time < ros_time_ - kBackSlack;
  const bool is_ahead = ros_time > ros_time_ + elapsed + kAheadSlack;
  look.jumped = !is_first && (is_back || is_ahead);
  if (look.jumped) ++epoch_;
  if (look.jumped || ros_time > ros_time_) {
    ros_time_ = ros_time;
    moved_at_ = now;
    moved_before_ = before;
  }
  look.ros_time = ros_time;
  look.now = now;
  look.epoch = epoch_;
  look.moved_at = moved_at_;
  return look;
}

long ClockWatch::epoch() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return epoch_;
}

}  // namespace pomdp_crowd_nav
