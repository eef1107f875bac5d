// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <mutex>
#include <optional>
#include <string>

#include "pomdp_crowd_nav/ros/drive.h"
#include "pomdp_crowd_nav/ros/move_base_server.h"

namespace pomdp_crowd_nav {

// The `move_base` action and the topic of RViz's "2D Nav Goal": one goal at a time, a newer one
// preempts. Thread-safe; call nothing here while holding the lock of the shared state.
class GoalServer {
 public:
  // What the owner does with goals. `check` brings one into the global frame or says in `reason`
  // why it is refused; `start` begins and `cancel` ends a trip, the latter by its number.
  struct Callbacks {
    std::function<std::optional<Pose>(const geometry_msgs::PoseStamped&, std::string& reason)>
        check;
    std::function<void(const Goal&)> start;
    std::function<void(long number)> cancel;
  };

  GoalServer(ros::NodeHandle& node, Callbacks callbacks);

  // Reports the end of a trip to whoever sent the goal; nothing if that is over already.
  void finish(const Ending& ending);

  void publishFeedback(const geometry_msgs::PoseStamped& base_position);

 private:
  using Server = MoveBaseServer;

  void onGoal(Server::GoalHandle handle);
  void onCancel(Server::GoalHandle handle);
  void onSimpleGoal(const geometry_msgs::PoseStamped& goal);

  Callbacks callbacks_;
  std::mutex mutex_;
  long last_number_ = 0;
  long active_number_ = 0;  // 0: none
  Server::GoalHandle active_;
  ros::Publisher goals_;
  ros::Subscriber simple_goals_;
  Server server_;
};

}  // namespace pomdp_crowd_nav
