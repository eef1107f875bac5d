// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace pomdp_crowd_nav {

// Where the panel finds its nodes; relative names are those of the node that shows the panel.
struct PanelNames {
  std::string space;  // namespace of the robot, empty: the node's own
  std::string planner_node = "planner_node";
  std::string sim_node = "sim_node";
};

inline bool operator==(const PanelNames& a, const PanelNames& b) {
  return a.space == b.space && a.planner_node == b.planner_node && a.sim_node == b.sim_node;
}

// Empty for names that ROS takes, else what is wrong with which.
std::string faultOf(const PanelNames& names);

// The name as seen from the panel's namespace, such as "/robot_1/planner_node/status".
std::string resolvedIn(const PanelNames& names, const std::string& name);

}  // namespace pomdp_crowd_nav
