// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/ros/panel/panel_names.h"

#include <gtest/gtest.h>

namespace pomdp_crowd_nav {
namespace {

TEST(PanelNames, AreSeenFromTheNamespace) {
  PanelNames names;
  EXPECT_EQ(resolvedIn(names, "planner_node"), "/planner_node");
  names.space = "robot_1";
  EXPECT_EQ(resolvedIn(names, "planner_node"), "/robot_1/planner_node");
  names.space = "/robot_1/";
  EXPECT_EQ(resolvedIn(names, "move_base"), "/robot_1/move_base");
  EXPECT_EQ(resolvedIn(names, "/elsewhere/sim_node"), "/elsewhere/sim_node");
}

TEST(PanelNames, ThatRosDoesNotTakeAreNamed) {
  PanelNames names;
  EXPECT_EQ(faultOf(names), "");
  names.space = "robot 1";
  EXPECT_EQ(faultOf(names), "the namespace must be a ROS name, got 'robot 1'");
  names.space = "~robot";
  EXPECT_EQ(faultOf(names), "the namespace must be a ROS name, got '~robot'");
  names = PanelNames();
  names.planner_node = "";
  EXPECT_EQ(faultOf(names), "the planner's node must not be empty");
  names = PanelNames();
  names.sim_node = "sim-node";
  EXPECT_EQ(faultOf(names), "the simulator's node must be a ROS name, got 'sim-node'");
}

}  // namespace
}  // namespace pomdp_crowd_nav
