// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace pomdp_crowd_nav {

// What a button or a field of the panel does now; the tooltip says what it would do, or why it
// does not.
struct Control {
  bool is_enabled = false;
  std::string tooltip;
};

struct PanelControls {
  Control planner, start, pause, stop, reset;
  bool is_resume = false;  // the start button ends a pause
};

struct ControlInputs {
  std::optional<std::uint8_t> state;  // PlannerStatus, none: it is not heard
  bool has_goal = false;              // one that could be sent (again)
  bool has_trip = false;              // the action has a goal that is not over
  bool has_simulator = false;
  bool is_busy = false;  // a call is under way
  std::string planner_node = "planner_node", sim_node = "sim_node";
};

PanelControls controlsFor(const ControlInputs& inputs);

// Planners that drive a vehicle of that kind, "holonomic" or "car"; any other word: all.
std::vector<std::string> plannersFor(const std::string& vehicle);

}  // namespace pomdp_crowd_nav
