// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <actionlib/server/action_server_base.h>
#include <actionlib/server/handle_tracker_deleter_imp.h>
#include <actionlib/server/server_goal_handle_imp.h>
#include <move_base_msgs/MoveBaseAction.h>
#include <ros/node_handle.h>

#include <functional>

namespace pomdp_crowd_nav {

// The action `move_base` with the topics and parameters of actionlib's own server, but on the
// steady clock: that one's timer of ROS time and its sums of stamps end the process when a clock or
// a cancel of the year 2106 comes along.
class MoveBaseServer : public actionlib::ActionServerBase<move_base_msgs::MoveBaseAction> {
 public:
  // In the namespace of `node`. Call start() when goals may come.
  MoveBaseServer(const ros::NodeHandle& node, const std::function<void(GoalHandle)>& on_goal,
                 const std::function<void(GoalHandle)>& on_cancel);

 private:
  void initialize() override;
  void publishResult(const actionlib_msgs::GoalStatus& status, const Result& result) override;
  void publishFeedback(const actionlib_msgs::GoalStatus& status, const Feedback& feedback) override;
  void publishStatus() override;
  void onTimer();

  ros::NodeHandle node_;
  ros::Publisher results_, feedback_, statuses_;
  ros::Subscriber goals_, cancels_;
  ros::SteadyTimer timer_;
};

}  // namespace pomdp_crowd_nav
