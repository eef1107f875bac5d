// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/ros/move_base_server.h"

#include <actionlib_msgs/GoalStatusArray.h>

#include <algorithm>

namespace pomdp_crowd_nav {
namespace {

using Lock = boost::recursive_mutex::scoped_lock;

// As actionlib looks them up.

std::uint32_t queueSize(const ros::NodeHandle& node, const std::string& key) {
  constexpr int kUsual = 50;
  const int size = node.param(key, kUsual);
  return static_cast<std::uint32_t>(size < 0 ? kUsual : size);
}

double statusFrequency(const ros::NodeHandle& node) {
  constexpr double kUsual = 5.0;  // [Hz]
  std::string key;
  if (!node.searchParam("actionlib_status_frequency", key)) return kUsual;
  return node.param(key, kUsual);
}

}  // namespace

MoveBaseServer::MoveBaseServer(const ros::NodeHandle& node,
                               const std::function<void(GoalHandle)>& on_goal,
                               const std::function<void(GoalHandle)>& on_cancel)
    : ActionServerBase(on_goal, on_cancel, false), node_(node) {}

void MoveBaseServer::initialize() {
  const std::uint32_t sent = queueSize(node_, "actionlib_server_pub_queue_size");
  const std::uint32_t heard = queueSize(node_, "actionlib_server_sub_queue_size");
  results_ = node_.advertise<ActionResult>("result", sent);
  feedback_ = node_.advertise<ActionFeedback>("feedback", sent);
  statuses_ = node_.advertise<actionlib_msgs::GoalStatusArray>("status", sent, true);
  status_list_timeout_ = ros::Duration(node_.param("status_list_timeout", 5.0));
  const double frequency = statusFrequency(node_);
  if (frequency > 0.0) {
    timer_ = node_.createSteadyTimer(ros::WallDuration(1.0 / frequency),
                                     [this](const ros::SteadyTimerEvent&) { onTimer(); });
  }
  goals_ = node_.subscribe<ActionGoal>(
      "goal", heard, [this](const ActionGoalConstPtr& goal) { goalCallback(goal); });
  cancels_ = node_.subscribe<actionlib_msgs::GoalID>(
      "cancel", heard, [this](const actionlib_msgs::GoalIDConstPtr& id) { cancelCallback(id); });
}

void MoveBaseServer::publishResult(const actionlib_msgs::GoalStatus& status, const Result& result) {
  const Lock lock(lock_);
  ActionResult message;
  message.header.stamp = ros::Time::now();
  message.status = status;
  message.result = result;
  results_.publish(message);
  publishStatus();
}

void MoveBaseServer::publishFeedback(const actionlib_msgs::GoalStatus& status,
                                     const Feedback& feedback) {
  const Lock lock(lock_);
  ActionFeedback message;
  message.header.stamp = ros::Time::now();
  message.status = status;
  message.feedback = feedback;
  feedback_.publish(message);
}

// A goal is forgotten some time after its end, which is as its canceller stamped it; an end of the
// future is now.
void MoveBaseServer::publishStatus() {
  const Lock lock(lock_);
  actionlib_msgs::GoalStatusArray message;
  const ros::Time now = message.header.stamp = ros::Time::now();
  for (auto it = status_list_.begin(); it != status_list_.end();) {
    message.status_list.push_back(it->status_);
    ros::Time& end = it->handle_destruction_time_;
    end = std::min(end, now);
    const bool is_old = !end.isZero() && now.toSec() - end.toSec() > status_list_timeout_.toSec();
    it = is_old ? status_list_.erase(it) : std::next(it);
  }
  statuses_.publish(message);
}

void MoveBaseServer::onTimer() {
  const Lock lock(lock_);
  if (started_) publishStatus();
}

}  // namespace pomdp_crowd_nav
