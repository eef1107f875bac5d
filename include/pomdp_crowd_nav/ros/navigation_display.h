// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>

#include <atomic>
#include <mutex>
#include <string>
#include <vector>

#include "pomdp_crowd_nav/ros/decision_loop.h"

namespace pomdp_crowd_nav {

// Publishes what the planner believes and intends, as data and as pictures; pictures are drawn only
// while somebody looks at them. Thread-safe.
class NavigationDisplay {
 public:
  NavigationDisplay(ros::NodeHandle& private_node, const std::string& global_frame,
                    const std::vector<Point>& destinations);

  void setSymbolSize(double size) { symbol_size_ = size; }  // [m], see markers.h
  void showGoal(const Goal& goal);
  void showDecision(const DecisionReport& report, const Planner& planner);
  void showBeliefs(const CrowdBelief& crowd);
  void clearPlans();  // when a trip is over

 private:
  std_msgs::Header header() const;
  std::vector<std::int64_t> attended();

  std::string frame_;
  std::vector<Point> destinations_;
  std::atomic<double> symbol_size_{0.5};  // [m]
  std::mutex mutex_;
  std::vector<std::int64_t> attended_;  // of the last decision
  ros::Publisher goal_, global_plan_, local_plan_, beliefs_, belief_markers_, search_tree_;
};

}  // namespace pomdp_crowd_nav
