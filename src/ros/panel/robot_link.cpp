// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/ros/panel/robot_link.h"

#include <actionlib_msgs/GoalID.h>
#include <dynamic_reconfigure/config_tools.h>

#include <algorithm>
#include <utility>

namespace pomdp_crowd_nav {
namespace {

using actionlib_msgs::GoalStatus;
using dynamic_reconfigure::ConfigTools;

bool isUnderWay(const GoalStatus& goal) {
  return goal.status == GoalStatus::PENDING || goal.status == GoalStatus::ACTIVE ||
         goal.status == GoalStatus::PREEMPTING || goal.status == GoalStatus::RECALLING;
}

}  // namespace

RobotLink::RobotLink(const PanelNames& names) : spinner_(1, &queue_) {
  node_.setCallbackQueue(&queue_);
  const std::string action = resolvedIn(names, "move_base");
  goals_ = node_.advertise<geometry_msgs::PoseStamped>(action + "_simple/goal", 1);
  cancels_ = node_.advertise<actionlib_msgs::GoalID>(action + "/cancel", 1);
  subscribe(names);
  spinner_.start();
}

RobotLink::~RobotLink() {
  spinner_.stop();
  queue_.disable();
}

void RobotLink::subscribe(const PanelNames& names) {
  const std::string planner = resolvedIn(names, names.planner_node);
  const std::string action = resolvedIn(names, "move_base");
  const std::string simulator = resolvedIn(names, names.sim_node);
  status_ = node_.subscribe(planner + "/status", 10, &RobotLink::onStatus, this);
  goal_ = node_.subscribe(planner + "/current_goal", 1, &RobotLink::onGoal, this);
  parameters_ = node_.subscribe(planner + "/parameter_updates", 1, &RobotLink::onParameters, this);
  action_ = node_.subscribe(action + "/status", 1, &RobotLink::onAction, this);
  metrics_ = node_.subscribe(simulator + "/metrics", 1, &RobotLink::onMetrics, this);
}

void RobotLink::onStatus(const PlannerStatus& status) {
  news_.with([&](RobotNews& news) { news.statuses.push_back(status); });
}

void RobotLink::onGoal(const geometry_msgs::PoseStamped& goal) {
  news_.with([&](RobotNews& news) { news.goal = goal; });
}

void RobotLink::onAction(const actionlib_msgs::GoalStatusArray& goals) {
  const auto& list = goals.status_list;
  const bool has_trip = std::any_of(list.begin(), list.end(), isUnderWay);
  news_.with([&](RobotNews& news) { news.has_trip = has_trip; });
}

void RobotLink::onParameters(const dynamic_reconfigure::Config& config) {
  std::string planner;
  double search_time = 0.0;
  const bool has_planner = ConfigTools::getParameter(config, "planner", planner);
  const bool has_time = ConfigTools::getParameter(config, "search_time", search_time);
  news_.with([&](RobotNews& news) {
    if (has_planner) news.planner = planner;
    if (has_time) news.search_time = search_time;
  });
}

RobotNews RobotLink::takeNews() {
  return news_.with([](RobotNews& news) {
    RobotNews taken = news;
    news.statuses.clear();
    return taken;
  });
}

bool RobotLink::sendGoal(geometry_msgs::PoseStamped goal) {
  goal.header.stamp = ros::Time();  // the newest transform will do
  goals_.publish(goal);
  return goals_.getNumSubscribers() > 0;
}

bool RobotLink::cancelGoals() {
  cancels_.publish(actionlib_msgs::GoalID());  // empty: all
  return cancels_.getNumSubscribers() > 0;
}

}  // namespace pomdp_crowd_nav
