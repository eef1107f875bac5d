// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <actionlib_msgs/GoalID.h>
#include <actionlib_msgs/GoalStatusArray.h>
#include <dynamic_reconfigure/Reconfigure.h>
#include <dynamic_reconfigure/config_tools.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>

#include <chrono>
#include <string>
#include <thread>
#include <vector>

#include "pomdp_crowd_nav/ros/conversions.h"
#include "pomdp_crowd_nav/ros/guarded.h"

namespace pomdp_crowd_nav {

// Topics and services of planner_node and sim_node, which do as they are told and keep what they
// were asked for. Has threads of its own.
class FakePlanner {
 public:
  struct Asked {
    std::vector<std::string> calls;  // in words
    PlannerStatus status;            // what it sends
    std::string planner = "2d_fmm";
    bool refuses = false;        // another planner, another simulation
    double answers_after = 0.0;  // [s]
  };

  explicit FakePlanner(const std::string& space, bool has_simulator = true)
      : node_(space), has_simulator_(has_simulator), spinner_(4, &queue_) {
    node_.setCallbackQueue(&queue_);
    advertise();
    setState(PlannerStatus::IDLE, "IDLE");
    timer_ = node_.createWallTimer(ros::WallDuration(0.05),
                                   [this](const ros::WallTimerEvent&) { send(); });
    spinner_.start();
    sendParameters();
  }

  ~FakePlanner() {
    spinner_.stop();
    queue_.disable();
  }

  // `change` gets the Asked.
  template <class Change>
  void change(const Change& change) {
    asked_.with(change);
  }

  void setState(std::uint8_t state, const std::string& name, const std::string& cause = "") {
    change([&](Asked& asked) {
      asked.status.state = state;
      asked.status.state_name = name;
      asked.status.stop_cause = cause;
    });
  }

  void showGoal(double x, double y) {
    geometry_msgs::PoseStamped goal;
    goal.header.frame_id = "map";
    goal.pose = toMessage(Pose{Point(x, y), 0.0});
    goal_.publish(goal);
  }

  bool wasAsked(const std::string& call) {
    return asked_.with([&](Asked& asked) {
      for (const std::string& it : asked.calls) {
        if (it == call) return true;
      }
      return false;
    });
  }

  std::size_t callCount() {
    return asked_.with([](Asked& asked) { return asked.calls.size(); });
  }

 private:
  void advertise() {
    const std::string planner = "planner_node";
    status_ = node_.advertise<PlannerStatus>(planner + "/status", 10, true);
    goal_ = node_.advertise<geometry_msgs::PoseStamped>(planner + "/current_goal", 1, true);
    parameters_ =
        node_.advertise<dynamic_reconfigure::Config>(planner + "/parameter_updates", 1, true);
    goals_ = node_.subscribe("move_base_simple/goal", 5, &FakePlanner::onGoal, this);
    cancels_ = node_.subscribe("move_base/cancel", 5, &FakePlanner::onCancel, this);
    services_ = {node_.advertiseService(planner + "/pause", &FakePlanner::onPause, this),
                 node_.advertiseService(planner + "/set_parameters", &FakePlanner::onSet, this)};
    if (!has_simulator_) return;
    metrics_ = node_.advertise<EpisodeMetricsMessage>("sim_node/metrics", 1);
    services_.push_back(node_.advertiseService("sim_node/reset", &FakePlanner::onReset, this));
  }

  void send() {
    PlannerStatus status = asked_.with([](Asked& asked) { return asked.status; });
    status.header.stamp = ros::Time::now();
    status_.publish(status);
    if (has_simulator_) metrics_.publish(EpisodeMetricsMessage());
  }

  void sendParameters() {
    dynamic_reconfigure::Config config;
    const std::string planner = asked_.with([](Asked& asked) { return asked.planner; });
    dynamic_reconfigure::ConfigTools::appendParameter(config, "planner", planner);
    dynamic_reconfigure::ConfigTools::appendParameter(config, "search_time", 0.35);
    parameters_.publish(config);
  }

  void note(const std::string& call) {
    const double delay = asked_.with([&](Asked& asked) {
      asked.calls.push_back(call);
      return asked.answers_after;
    });
    std::this_thread::sleep_for(std::chrono::duration<double>(delay));
  }

  bool refuses() {
    return asked_.with([](Asked& asked) { return asked.refuses; });
  }

  void onGoal(const geometry_msgs::PoseStamped& goal) {
    note("goal " + goal.header.frame_id + " " + std::to_string(std::lround(goal.pose.position.x)) +
         " " + std::to_string(std::lround(goal.pose.position.y)));
  }

  void onCancel(const actionlib_msgs::GoalID& goal) {
    note(goal.id.empty() && goal.stamp.isZero() ? "cancel all" : "cancel something");
  }

  bool onPause(PauseService::Request& request, PauseService::Response& response) {
    note(request.data ? "pause" : "resume");
    response.success = true;
    response.message = request.data ? "paused" : "resumed";
    return true;
  }

  bool onSet(dynamic_reconfigure::Reconfigure::Request& request,
             dynamic_reconfigure::Reconfigure::Response& response) {
    std::string planner;
    dynamic_reconfigure::ConfigTools::getParameter(request.config, "planner", planner);
    note("planner " + planner);
    if (!refuses()) change([&](Asked& asked) { asked.planner = planner; });
    dynamic_reconfigure::ConfigTools::appendParameter(
        response.config, "planner", asked_.with([](Asked& asked) { return asked.planner; }));
    sendParameters();
    return true;
  }

  bool onReset(ResetSimulation::Request& request, ResetSimulation::Response& response) {
    note("reset " + std::to_string(request.pedestrians) + " " + std::to_string(request.seed));
    response.success = !refuses();
    response.message = refuses() ? "too many people" : "simulating a field";
    return true;
  }

  ros::CallbackQueue queue_;
  ros::NodeHandle node_;
  bool has_simulator_;
  Guarded<Asked> asked_{Asked()};
  ros::Publisher status_, goal_, parameters_, metrics_;
  ros::Subscriber goals_, cancels_;
  std::vector<ros::ServiceServer> services_;
  ros::WallTimer timer_;
  ros::AsyncSpinner spinner_;
};

}  // namespace pomdp_crowd_nav
