// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "pomdp_crowd_nav/ros/panel/call_runner.h"
#include "pomdp_crowd_nav/ros/panel/cycle_history.h"
#include "pomdp_crowd_nav/ros/panel/panel_controls.h"
#include "pomdp_crowd_nav/ros/panel/panel_names.h"
#include "pomdp_crowd_nav/ros/panel/planner_watch.h"
#include "pomdp_crowd_nav/ros/panel/robot_calls.h"
#include "pomdp_crowd_nav/ros/panel/robot_connection.h"
#include "pomdp_crowd_nav/ros/panel/robot_link.h"

namespace pomdp_crowd_nav {

// All that the panel shows.
struct PanelPicture {
  StatusTexts texts;
  PanelControls controls;
  std::vector<std::string> planners;  // to choose from
  std::string planner;                // that drives, empty: not known
  CycleHistory cycles;
  std::optional<double> deadline;  // [s], of a decision
  std::string message;             // what came of the last press of a button
  bool is_complaint = false;       // the message
  bool is_busy = false;            // a call is under way
};

// The panel without its widgets. One thread uses it and is never made to wait: whatever talks to
// the master or waits for an answer happens in other threads. Call tick() some times a second.
class PanelSession {
 public:
  explicit PanelSession(const PanelNames& names);

  const PanelNames& names() const { return names_; }
  // Of other nodes; says in the message why not where ROS does not take the names.
  bool setNames(const PanelNames& names);

  void tick();
  PanelPicture picture() const;

  // What the buttons do; without effect while their control is disabled.
  void start();
  void pause();
  void stop();
  void choosePlanner(const std::string& planner);
  void reset(const ResetRequest& request);

 private:
  void takeNews(double now);
  ControlInputs controlInputs() const;
  PanelControls controls() const { return controlsFor(controlInputs()); }
  std::optional<double> deadline() const;
  void ask(const std::string& whom, std::function<CallResult(InterruptibleCall&)> work);
  void say(const CallResult& result);

  PanelNames names_;
  RobotConnection connection_;
  CallRunner calls_;
  PlannerWatch watch_;
  CycleHistory cycles_;
  RobotNews news_;  // the newest of each kind
  bool has_simulator_ = false;
  double now_ = 0.0;  // [s], steady clock, of the last tick
  CallResult said_{true, ""};
};

}  // namespace pomdp_crowd_nav
