// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "pomdp_crowd_nav/ros/inputs.h"

namespace pomdp_crowd_nav {

// How one input does, for `/diagnostics`.
struct InputHealth {
  enum class Level { kOk, kWarning, kError };

  std::string name;  // of kInputNames
  Level level = Level::kOk;
  std::string text;
  std::string topic;
  std::string frame;   // of the newest message
  double age = -1.0;   // [s], negative: never came
  double limit = 0.0;  // [s], 0: none
  double rate = 0.0;   // [Hz]
  unsigned refused = 0;
  std::string last_fault;  // of the refused messages
};

constexpr const char* kInputNames[] = {"odometry", "people", "map", "transforms", "clock"};

// One for each of kInputNames, in that order; whether or not there is a goal.
std::vector<InputHealth> inputHealth(const Inputs& inputs, const InputLimits& limits, double now);

}  // namespace pomdp_crowd_nav
