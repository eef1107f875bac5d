// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/ros/goal_server.h"

#include <ros/console.h>

namespace pomdp_crowd_nav {
namespace {

using actionlib_msgs::GoalStatus;

}  // namespace

GoalServer::GoalServer(ros::NodeHandle& node, Callbacks callbacks)
    : callbacks_(std::move(callbacks)),
      server_(
          ros::NodeHandle(node, "move_base"), [this](Server::GoalHandle handle) { onGoal(handle); },
          [this](Server::GoalHandle handle) { onCancel(handle); }) {
  goals_ = node.advertise<move_base_msgs::MoveBaseActionGoal>("move_base/goal", 1);
  simple_goals_ = node.subscribe("move_base_simple/goal", 1, &GoalServer::onSimpleGoal, this);
  server_.start();
}

void GoalServer::onSimpleGoal(const geometry_msgs::PoseStamped& goal) {
  move_base_msgs::MoveBaseActionGoal action_goal;
  action_goal.header.stamp = ros::Time::now();
  action_goal.goal.target_pose = goal;
  goals_.publish(action_goal);
}

void GoalServer::onGoal(Server::GoalHandle handle) {
  std::string reason;
  const std::optional<Pose> pose = callbacks_.check(handle.getGoal()->target_pose, reason);
  if (!pose) {
    ROS_WARN("goal refused: %s", reason.c_str());
    handle.setRejected(move_base_msgs::MoveBaseResult(), reason);
    return;
  }
  if (handle.getGoalStatus().status == GoalStatus::RECALLING) {
    handle.setCanceled(move_base_msgs::MoveBaseResult(), "cancelled");
    return;
  }
  handle.setAccepted("on the way");
  Goal goal{0, *pose};
  std::optional<Server::GoalHandle> previous;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (active_number_ != 0) previous = active_;
    active_ = handle;
    active_number_ = goal.number = ++last_number_;
  }
  if (previous) {
    previous->setCanceled(move_base_msgs::MoveBaseResult(), "preempted by a newer goal");
  }
  callbacks_.start(goal);
  // A cancel before the start found no trip of this goal to end.
  if (handle.getGoalStatus().status == GoalStatus::PREEMPTING) callbacks_.cancel(goal.number);
}

// A newer goal may take over at any moment.
void GoalServer::onCancel(Server::GoalHandle handle) {
  long number = 0;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (active_number_ == 0 || !(active_ == handle)) return;
    number = active_number_;
  }
  callbacks_.cancel(number);
}

void GoalServer::finish(const Ending& ending) {
  Server::GoalHandle handle;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (active_number_ != ending.goal.number) return;
    handle = active_;
    active_number_ = 0;
  }
  const move_base_msgs::MoveBaseResult result;
  switch (ending.outcome) {
    case Outcome::kReached:
      return handle.setSucceeded(result, ending.text);
    case Outcome::kCancelled:
    case Outcome::kPreempted:
      return handle.setCanceled(result, ending.text);
    case Outcome::kFailed:
      return handle.setAborted(result, ending.text);
  }
}

void GoalServer::publishFeedback(const geometry_msgs::PoseStamped& base_position) {
  Server::GoalHandle handle;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (active_number_ == 0) return;
    handle = active_;
  }
  move_base_msgs::MoveBaseFeedback feedback;
  feedback.base_position = base_position;
  handle.publishFeedback(feedback);
}

}  // namespace pomdp_crowd_nav
