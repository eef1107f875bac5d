// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <mutex>

namespace pomdp_crowd_nav {

// Compares ROS time with the steady clock: does it jump, does it stand still? Thread-safe.
//
// Both are read here, one thread at a time, so that a thread that is held up between the two, or
// the whole process, takes no old time for a jump.
class ClockWatch {
 public:
  // A system clock may be set back by less; simulated time may run ahead of a look by less. [s]
  static constexpr double kBackSlack = 0.1;
  static constexpr double kAheadSlack = 2.0;

  using Clock = std::function<double()>;  // [s]

  // `ros_time` is 0 before the first one.
  ClockWatch(Clock ros_time, Clock steady);
  ClockWatch();  // with the clocks of ROS and of the machine

  struct Look {
    double ros_time = 0.0;  // [s]
    double now = 0.0;       // [s], steady clock
    bool jumped = false;    // since the last look, back or ahead
    long epoch = 0;         // jumps so far; what was measured in another epoch means nothing now
    double moved_at = 0.0;  // [s], steady clock: ROS time was last seen to move on
  };

  Look look();

  long epoch() const;

 private:
  mutable std::mutex mutex_;
  Clock clock_, steady_;
  double ros_time_ = 0.0;
  double moved_at_;      // [s], ROS time was last seen to move on, at the latest
  double moved_before_;  // [s], the same, at the earliest
  long epoch_ = 0;
};

}  // namespace pomdp_crowd_nav
