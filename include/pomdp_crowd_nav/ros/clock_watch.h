// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mutex>

namespace pomdp_crowd_nav {

// Compares ROS time with the steady clock: does it jump, does it stand still? Thread-safe.
class ClockWatch {
 public:
  // A system clock may be set back by less; simulated time may run ahead of a look by less. [s]
  static constexpr double kBackSlack = 0.1;
  static constexpr double kAheadSlack = 2.0;

  // `now` [s], steady clock.
  explicit ClockWatch(double now) : looked_at_(now), moved_at_(now) {}

  struct Look {
    bool jumped = false;    // since the last look, back or ahead
    long epoch = 0;         // jumps so far; what was measured in another epoch means nothing now
    double moved_at = 0.0;  // [s], steady clock: ROS time was last seen to move on
  };

  // `ros_time` [s], 0 before the first one; `now` [s], steady clock.
  Look look(double ros_time, double now);

  long epoch() const;

 private:
  mutable std::mutex mutex_;
  double ros_time_ = 0.0;
  double looked_at_;
  double moved_at_;
  long epoch_ = 0;
};

}  // namespace pomdp_crowd_nav
