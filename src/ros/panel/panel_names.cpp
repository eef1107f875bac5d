// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/ros/panel/panel_names.h"

#include <ros/names.h>

namespace pomdp_crowd_nav {
namespace {

std::string faultOf(const std::string& what, const std::string& name, bool may_be_empty) {
  if (name.empty()) return may_be_empty ? "" : what + " must not be empty";
  std::string error;
  if (name[0] != '~' && ros::names::validate(name, error)) return "";
  return what + " must be a ROS name, got '" + name + "'";
}

}  // namespace

std::string faultOf(const PanelNames& names) {
  for (const std::string& fault : {faultOf("the namespace", names.space, true),
                                   faultOf("the planner's node", names.planner_node, false),
                                   faultOf("the simulator's node", names.sim_node, false)}) {
    if (!fault.empty()) return fault;
  }
  return "";
}

std::string resolvedIn(const PanelNames& names, const std::string& name) {
  if (name[0] == '/') return ros::names::clean(name);
  return ros::names::resolve(ros::names::append(names.space, name), false);
}

}  // namespace pomdp_crowd_nav
