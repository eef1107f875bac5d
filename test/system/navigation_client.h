// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <actionlib/client/simple_action_client.h>
#include <geometry_msgs/Twist.h>
#include <move_base_msgs/MoveBaseAction.h>
#include <ros/ros.h>
#include <rosgraph_msgs/Log.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

#include "pomdp_crowd_nav/ros/conversions.h"

namespace pomdp_crowd_nav {

// What the nodes write to their logs.
class LogListener {
 public:
  LogListener() { subscriber_ = node_.subscribe("/rosout", 100, &LogListener::onLog, this); }

  // To another node than its own.
  bool isConnected() const { return subscriber_.getNumPublishers() > 1; }

  bool has(const std::string& text) const { return log_.find(text) != std::string::npos; }

  // Programs that it hears; this one is among them.
  int programs() const { return static_cast<int>(subscriber_.getNumPublishers()); }

 private:
  void onLog(const rosgraph_msgs::Log& line) { log_ += line.msg + "\n"; }

  ros::NodeHandle node_;
  ros::Subscriber subscriber_;
  std::string log_;
};

// A plain actionlib client of the planner that also listens to its status and commands. It has no
// thread of its own, in which actionlib's client would change its state without a lock: waitUntil
// of any client serves all of them.
class NavigationClient {
 public:
  using State = actionlib::SimpleClientGoalState;

  // Of the planner in that namespace, which ends with a slash.
  explicit NavigationClient(const std::string& space = "")
      : action_(space + "move_base", false), node_(space), private_node_(space + "planner_node") {
    status_subscriber_ = private_node_.subscribe("status", 10, &NavigationClient::onStatus, this);
    command_subscriber_ = node_.subscribe("cmd_vel", 100, &NavigationClient::onCommand, this);
  }

  bool connect() {
    return waitUntil(20.0, [this] { return action_.isServerConnected() && status_count_ > 0; });
  }

  void send(double x, double y, const std::string& frame = "map",
            const ros::Time& stamp = ros::Time()) {
    send(Pose{Point(x, y), 0.0}, frame, stamp);
  }

  void send(const Pose& pose, const std::string& frame, const ros::Time& stamp = ros::Time()) {
    move_base_msgs::MoveBaseGoal goal;
    goal.target_pose.header.stamp = stamp;
    goal.target_pose.header.frame_id = frame;
    goal.target_pose.pose = toMessage(pose);
    feedback_count_ = 0;
    action_.sendGoal(goal, {}, {}, [this](const auto&) { ++feedback_count_; });
  }

  void cancel() { action_.cancelGoal(); }
  void cancelAll() { action_.cancelAllGoals(); }

  State state() { return action_.getState(); }
  std::string text() { return state().getText(); }

  bool waitForEnd(double timeout) {
    return waitUntil(timeout, [this] { return state().isDone(); });
  }

  bool waitForMotion(double timeout, double speed = 0.3) {
    return waitUntil(timeout, [&] { return commandedSpeed() > speed; });
  }

  bool waitForRest(double timeout) {
    return waitUntil(timeout, [this] { return commandedSpeed() == 0.0; });
  }

  bool waitForStop(double timeout, const std::string& cause) {
    return waitUntil(timeout, [&] {
      return status_.stop_cause.find(cause) != std::string::npos && commandedSpeed() == 0.0;
    });
  }

  // Wall clock, so that a frozen ROS clock does not freeze the test.
  static bool waitUntil(double timeout, const std::function<bool()>& condition) {
    const ros::WallTime give_up = ros::WallTime::now() + ros::WallDuration(timeout);
    while (ros::ok()) {
      ros::spinOnce();
      if (condition()) return true;
      if (ros::WallTime::now() >= give_up) return false;
      ros::WallDuration(0.01).sleep();
    }
    return false;
  }

  double commandedSpeed() const { return std::hypot(command_.linear.x, command_.linear.y); }
  double topSpeed() const { return top_speed_; }
  bool areCommandsFinite() const { return are_commands_finite_; }
  int feedbackCount() const { return feedback_count_; }
  int commandCount() const { return command_count_; }
  unsigned mostTrials() const { return most_trials_; }
  const PlannerStatus& status() const { return status_; }

  // Whether such a cause was reported since they were last forgotten, however shortly.
  bool hasReported(const std::string& cause) const {
    return causes_.find(cause) != std::string::npos;
  }
  const std::string& causes() const { return causes_; }
  void forgetCauses() { causes_.clear(); }

 private:
  void onStatus(const PlannerStatus& status) {
    status_ = status;
    causes_ += status.stop_cause + "\n";
    most_trials_ = std::max(most_trials_, status.trials);
    ++status_count_;
  }

  void onCommand(const geometry_msgs::Twist& command) {
    command_ = command;
    ++command_count_;
    are_commands_finite_ = are_commands_finite_ && toCommand(command).has_value();
    top_speed_ = std::max(top_speed_, commandedSpeed());
  }

  actionlib::SimpleActionClient<move_base_msgs::MoveBaseAction> action_;
  ros::NodeHandle node_, private_node_;
  ros::Subscriber status_subscriber_, command_subscriber_;
  PlannerStatus status_;
  std::string causes_;  // reported, a line each
  geometry_msgs::Twist command_;
  std::uint32_t most_trials_ = 0;
  int status_count_ = 0;
  int command_count_ = 0;
  int feedback_count_ = 0;
  double top_speed_ = 0.0;
  bool are_commands_finite_ = true;
};

}  // namespace pomdp_crowd_nav
