// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/callback_queue.h>
#include <ros/ros.h>

#include <atomic>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "pomdp_crowd_nav/ros/belief_markers.h"
#include "pomdp_crowd_nav/ros/decision_loop.h"
#include "pomdp_crowd_nav/ros/latched_layer.h"
#include "pomdp_crowd_nav/ros/markers.h"
#include "pomdp_crowd_nav/ros/trail.h"

namespace pomdp_crowd_nav {

// Publishes what the planner believes and intends, as data and as pictures (doc/view.md).
//
// Pictures are drawn in a thread of their own, and only while somebody looks at them: neither
// decisions nor commands wait for them. `show...` and `clearPlans` may be called from any thread.
class NavigationDisplay {
 public:
  // `drive` must outlive the display.
  NavigationDisplay(const ros::NodeHandle& private_node, const PlannerNodeParams& params,
                    Guarded<Drive>& drive);
  ~NavigationDisplay();

  void showGoal(const Goal& goal);
  void showPlanner(const Planner& planner);  // that decides from now on
  void showDecision(const DecisionReport& report, const Planner& planner);
  void clearPlans();  // when a trip is over

 private:
  // What the planning thread leaves for the display's.
  struct News {
    std::vector<std::int64_t> attended;
    std::optional<TreeScene> tree;  // to be drawn
    Guidance guidance;              // of the present planner
    bool has_new_guidance = false;
  };

  void advertise(ros::NodeHandle& node);
  void run();
  void onTimer();
  void followRobot();
  void renewLayers();
  void drawTree();
  void drawBeliefs();
  void drawRobot();
  std::optional<nav_msgs::OccupancyGrid> makeArrivalTime();
  std::optional<visualization_msgs::MarkerArray> makeRoadmap();
  std_msgs::Header header() const;

  FrameNames frames_;
  std::vector<Point> destinations_;
  InputLimits limits_;
  double radius_;  // [m], of the robot
  Guarded<Drive>& drive_;
  Guarded<News> news_{News()};

  // All below but the publishers are touched by the display's thread only.
  Trail driven_;
  CrowdTrails crowd_trails_;
  std::shared_ptr<const StaticMap> map_;
  double symbol_size_ = 0.5;    // [m], see markers.h
  Point headline_{0.0, 0.0};    // [m], see RobotScene
  double letter_size_ = 1.0;    // [m]
  std::optional<Point> robot_;  // [m]
  long ticks_ = 0;

  ros::CallbackQueue queue_;
  ros::Publisher goal_, global_plan_, local_plan_, beliefs_;
  ros::Publisher belief_markers_, robot_markers_, search_tree_;
  LatchedLayer<nav_msgs::OccupancyGrid> arrival_time_;
  LatchedLayer<visualization_msgs::MarkerArray> roadmap_;
  ros::SteadyTimer timer_;
  std::atomic<bool> stop_{false};
  std::thread thread_;
};

}  // namespace pomdp_crowd_nav
