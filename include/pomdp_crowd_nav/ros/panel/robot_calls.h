// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <geometry_msgs/PoseStamped.h>
#include <ros/service_client.h>

#include <cstdint>
#include <mutex>
#include <optional>
#include <string>

#include "pomdp_crowd_nav/ros/panel/call_runner.h"
#include "pomdp_crowd_nav/ros/panel/panel_names.h"

namespace pomdp_crowd_nav {

// A service call that another thread can end.
class InterruptibleCall {
 public:
  // Returns whether an answer came; blocks.
  template <class Service>
  bool call(const std::string& name, Service& service);

  void interrupt();
  bool isInterrupted() const;

 private:
  mutable std::mutex mutex_;
  ros::ServiceClient client_;
  bool is_interrupted_ = false;
};

struct ResetRequest {
  int pedestrians = -1;  // negative: as many as before
  std::uint64_t seed = 1;
};

// Parameters of the planner that only the parameter server tells.
struct PlannerFacts {
  double planner_frequency = 2.0;  // [Hz]
  std::string vehicle = "holonomic";
};

// All of them block, and say in the result what came of it.
CallResult setPause(InterruptibleCall& call, const PanelNames& names, bool pause);
CallResult choosePlanner(InterruptibleCall& call, const PanelNames& names,
                         const std::string& planner);
CallResult resetSimulation(InterruptibleCall& call, const PanelNames& names,
                           const ResetRequest& request);
PlannerFacts readPlannerFacts(const PanelNames& names);

// The goal of the world that the simulator was started with, where its file can be read here.
std::optional<geometry_msgs::PoseStamped> goalOfWorld(const PanelNames& names);

}  // namespace pomdp_crowd_nav
