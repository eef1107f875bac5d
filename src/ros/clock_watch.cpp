// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/ros/clock_watch.h"

#include <algorithm>

namespace pomdp_crowd_nav {

ClockWatch::Look ClockWatch::look(double ros_time, double now) {
  const std::lock_guard<std::mutex> lock(mutex_);
  Look look;
  const double elapsed = std::max(0.0, now - looked_at_);
  const bool is_first = ros_time_ <= 0.0;
  const bool is_back = ros_time < ros_time_ - kBackSlack;
  const bool is_ahead = ros_time > ros_time_ + elapsed + kAheadSlack;
  look.jumped = !is_first && (is_back || is_ahead);
  if (look.jumped) ++epoch_;
  if (look.jumped || ros_time > ros_time_) {
    ros_time_ = ros_time;
    moved_at_ = std::max(moved_at_, now);
  }
  looked_at_ = std::max(looked_at_, now);
  look.epoch = epoch_;
  look.moved_at = moved_at_;
  return look;
}

long ClockWatch::epoch() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return epoch_;
}

}  // namespace pomdp_crowd_nav
