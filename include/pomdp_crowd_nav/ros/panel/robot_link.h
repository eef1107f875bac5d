// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <actionlib_msgs/GoalStatusArray.h>
#include <dynamic_reconfigure/Config.h>
#include <geometry_msgs/PoseStamped.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "pomdp_crowd_nav/ros/guarded.h"
#include "pomdp_crowd_nav/ros/messages.h"
#include "pomdp_crowd_nav/ros/panel/panel_names.h"

namespace pomdp_crowd_nav {

// What has come in since it was last looked at; the newest goal and choice stay.
struct RobotNews {
  std::vector<PlannerStatus> statuses;
  std::optional<geometry_msgs::PoseStamped> goal;
  std::optional<std::string> planner;
  std::optional<double> search_time;  // [s]
  bool has_trip = false;              // the action has a goal that is not over
};

// The topics between the panel and one robot. Making one and letting it go talk to the master,
// which takes as long as the master likes; nothing else does. Messages are taken by a thread of its
// own.
class RobotLink {
 public:
  explicit RobotLink(const PanelNames& names);
  ~RobotLink();
  RobotLink(const RobotLink&) = delete;
  RobotLink& operator=(const RobotLink&) = delete;

  RobotNews takeNews();
  int plannerPublishers() const { return static_cast<int>(status_.getNumPublishers()); }
  bool hasSimulator() const { return metrics_.getNumPublishers() > 0; }

  // Return whether anybody listens.
  bool sendGoal(geometry_msgs::PoseStamped goal);
  bool cancelGoals();

 private:
  void subscribe(const PanelNames& names);
  void onStatus(const PlannerStatus& status);
  void onGoal(const geometry_msgs::PoseStamped& goal);
  void onAction(const actionlib_msgs::GoalStatusArray& goals);
  void onMetrics(const EpisodeMetricsMessage&) {}  // that it is there is enough
  void onParameters(const dynamic_reconfigure::Config& config);

  Guarded<RobotNews> news_{RobotNews()};
  ros::CallbackQueue queue_;
  ros::NodeHandle node_;
  ros::Subscriber status_, goal_, action_, parameters_, metrics_;
  ros::Publisher goals_, cancels_;
  ros::AsyncSpinner spinner_;
};

}  // namespace pomdp_crowd_nav
