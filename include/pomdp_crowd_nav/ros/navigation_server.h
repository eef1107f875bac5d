// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/callback_queue.h>
#include <ros/ros.h>

#include <atomic>

#include "pomdp_crowd_nav/ros/command_loop.h"
#include "pomdp_crowd_nav/ros/decision_loop.h"
#include "pomdp_crowd_nav/ros/goal_server.h"
#include "pomdp_crowd_nav/ros/input_listener.h"
#include "pomdp_crowd_nav/ros/navigation_display.h"
#include "pomdp_crowd_nav/ros/path_service.h"
#include "pomdp_crowd_nav/ros/reconfiguration.h"
#include "pomdp_crowd_nav/ros/status_reporter.h"

namespace pomdp_crowd_nav {

// The planner node: inputs, goals, planning thread and command timer around one shared state.
//
// Callbacks write the newest inputs; the planning thread reads them and hands motions over; a timer
// with a thread of its own turns the present motion into `cmd_vel` and ends trips.
class NavigationServer {
 public:
  NavigationServer(ros::NodeHandle node, ros::NodeHandle private_node,
                   const PlannerNodeParams& params);
  ~NavigationServer();

  // For the end of the node: ends the trip, if any, waits until the base is at rest or one second
  // more has passed than it takes to brake, and leaves a zero as the last command.
  void stopBase();

 private:
  std::optional<Pose> checkGoal(const geometry_msgs::PoseStamped& goal, std::string& reason);
  void startTrip(const Goal& goal);
  void failTrip(const Goal& goal, const std::string& reason);
  std::string adoptParams(const NavigationParams& params);
  void reportDecision(const DecisionReport& report, const Planner& planner);

  void onCommandTimer();
  void onReportTimer();
  PlannerStatus publishStatus();
  void warnOfMissingInput(const PlannerStatus& status);
  bool onPause(PauseService::Request& request, PauseService::Response& response);

  ros::SteadyTimer startTimer(ros::NodeHandle& node, double period, ros::CallbackQueue* queue,
                              void (NavigationServer::*callback)());

  PlannerNodeParams params_;
  Guarded<Drive> drive_;
  MapWork map_work_;
  CommandLoop command_loop_;
  std::atomic<bool> is_active_{false};  // commands are being published
  long reports_ = 0;
  long reports_without_input_ = 0;
  std::uint8_t last_state_ = 0;

  InputListener inputs_;
  NavigationDisplay display_;
  StatusReporter status_;
  ros::Publisher commands_;
  GoalServer goals_;
  ros::ServiceServer pause_;
  PathService make_plan_;
  DecisionLoop decisions_;
  Reconfiguration reconfiguration_;

  ros::CallbackQueue command_queue_;
  ros::AsyncSpinner command_spinner_;
  ros::SteadyTimer command_timer_, report_timer_;
};

}  // namespace pomdp_crowd_nav
