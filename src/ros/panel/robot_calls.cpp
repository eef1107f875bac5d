// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/ros/panel/robot_calls.h"

#include <dynamic_reconfigure/Reconfigure.h>
#include <dynamic_reconfigure/config_tools.h>
#include <fmt/format.h>
#include <ros/node_handle.h>
#include <ros/param.h>

#include <limits>

#include "pomdp_crowd_nav/ros/conversions.h"
#include "pomdp_crowd_nav/sim/world_file.h"

namespace pomdp_crowd_nav {
namespace {

using dynamic_reconfigure::ConfigTools;

CallResult noAnswer(const std::string& service) { return {false, service + " does not answer"}; }

}  // namespace

// Only a persistent client's call ends when the client is shut down by another thread.
template <class Service>
bool InterruptibleCall::call(const std::string& name, Service& service) {
  ros::NodeHandle node;
  ros::ServiceClient client = node.serviceClient<Service>(name, true);
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (is_interrupted_) return false;
    client_ = client;
  }
  if (!client.isValid()) return false;  // there is no such service
  const bool is_answered = client.call(service);
  const std::lock_guard<std::mutex> lock(mutex_);
  client_.shutdown();
  client_ = ros::ServiceClient();
  return is_answered;
}

void InterruptibleCall::interrupt() {
  const std::lock_guard<std::mutex> lock(mutex_);
  is_interrupted_ = true;
  client_.shutdown();
}

bool InterruptibleCall::isInterrupted() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return is_interrupted_;
}

CallResult setPause(InterruptibleCall& call, const PanelNames& names, bool pause) {
  const std::string name = resolvedIn(names, names.planner_node) + "/pause";
  PauseService service;
  service.request.data = pause;
  if (!call.call(name, service)) return noAnswer(name);
  return {service.response.success != 0, service.response.message};
}

CallResult choosePlanner(InterruptibleCall& call, const PanelNames& names,
                         const std::string& planner) {
  const std::string node = resolvedIn(names, names.planner_node);
  dynamic_reconfigure::Reconfigure service;
  ConfigTools::appendParameter(service.request.config, "planner", planner);
  if (!call.call(node + "/set_parameters", service)) return noAnswer(node + "/set_parameters");
  std::string present;
  ConfigTools::getParameter(service.response.config, "planner", present);
  if (present == planner) return {true, "planner " + planner};
  return {false, fmt::format("{} keeps the planner {}; its log says why", node, present)};
}

CallResult resetSimulation(InterruptibleCall& call, const PanelNames& names,
                           const ResetRequest& request) {
  const std::string name = resolvedIn(names, names.sim_node) + "/reset";
  ResetSimulation service;
  service.request.pedestrians = request.pedestrians;
  service.request.seed = request.seed;
  if (!call.call(name, service)) return noAnswer(name);
  const bool is_done = service.response.success != 0;
  return {is_done, (is_done ? "reset: " : "not reset: ") + service.response.message};
}

PlannerFacts readPlannerFacts(const PanelNames& names) {
  const std::string node = resolvedIn(names, names.planner_node);
  PlannerFacts facts;
  ros::param::get(node + "/planner_frequency", facts.planner_frequency);
  ros::param::get(node + "/vehicle", facts.vehicle);
  return facts;
}

std::optional<geometry_msgs::PoseStamped> goalOfWorld(const PanelNames& names) {
  const std::string node = resolvedIn(names, names.sim_node);
  std::string file;
  if (!ros::param::get(node + "/world_file", file)) return std::nullopt;
  geometry_msgs::PoseStamped goal;
  goal.header.frame_id = ros::param::param<std::string>(node + "/global_frame", "map");
  goal.pose = toMessage(Pose{loadWorld(file).goal, 0.0});
  return goal;
}

}  // namespace pomdp_crowd_nav
