// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "pomdp_crowd_nav/ros/messages.h"

namespace pomdp_crowd_nav {

// How a state is to be seen from afar.
enum class Mood { kUnknown, kIdle, kDriving, kWaiting, kTrouble };

// A status of the planner as a person reads it; texts may be empty.
struct StatusTexts {
  Mood mood = Mood::kUnknown;
  std::string state;     // "DRIVING", "no planner_node"
  std::string cause;     // why the base does not drive
  std::string decision;  // the last one: time, trials, nodes
  std::string late;      // decisions that came too late
  std::string odometry;  // ages of the inputs
  std::string people;
  std::string map;
};

// `deadline` [s]: until when a decision must be there, where that is known.
StatusTexts textsOf(const PlannerStatus& status, std::optional<double> deadline);

}  // namespace pomdp_crowd_nav
