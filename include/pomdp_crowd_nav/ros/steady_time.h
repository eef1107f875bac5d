// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>

namespace pomdp_crowd_nav {

// Deadlines, ages and motions are on the steady clock, in seconds: it never jumps and never stands
// still, whatever happens to ROS time.
using SteadyClock = std::chrono::steady_clock;

inline double steadySeconds() {
  return std::chrono::duration<double>(SteadyClock::now().time_since_epoch()).count();
}

inline SteadyClock::time_point toSteadyTime(double seconds) {
  return SteadyClock::time_point(
      std::chrono::duration_cast<SteadyClock::duration>(std::chrono::duration<double>(seconds)));
}

}  // namespace pomdp_crowd_nav
