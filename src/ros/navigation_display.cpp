// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/ros/navigation_display.h"

#include "pomdp_crowd_nav/ros/markers.h"

namespace pomdp_crowd_nav {
namespace {

constexpr int kMaxTreeEdges = 4000;  // 8000 points

std::vector<Point> positions(const std::vector<VehicleState>& plan) {
  std::vector<Point> points;
  for (const VehicleState& state : plan) points.push_back(state.position);
  return points;
}

}  // namespace

NavigationDisplay::NavigationDisplay(ros::NodeHandle& private_node, const std::string& global_frame,
                                     const std::vector<Point>& destinations)
    : frame_(global_frame), destinations_(destinations) {
  goal_ = private_node.advertise<geometry_msgs::PoseStamped>("current_goal", 1, true);
  global_plan_ = private_node.advertise<nav_msgs::Path>("global_plan", 1);
  local_plan_ = private_node.advertise<nav_msgs::Path>("local_plan", 1);
  beliefs_ = private_node.advertise<CrowdBeliefMessage>("beliefs", 1);
  belief_markers_ = private_node.advertise<visualization_msgs::MarkerArray>("belief_markers", 1);
  search_tree_ = private_node.advertise<visualization_msgs::MarkerArray>("search_tree", 1);
}

std_msgs::Header NavigationDisplay::header() const {
  std_msgs::Header header;
  header.frame_id = frame_;
  header.stamp = ros::Time::now();
  return header;
}

void NavigationDisplay::showGoal(const Goal& goal) {
  geometry_msgs::PoseStamped message;
  message.header = header();
  message.pose = toMessage(goal.pose);
  goal_.publish(message);
}

void NavigationDisplay::showDecision(const DecisionReport& report, const Planner& planner) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    attended_ = report.decision.attended;
  }
  if (global_plan_.getNumSubscribers() > 0) {
    const std::vector<Point>& path = report.decision.path;
    const Point& here = report.situation.vehicle.position;
    global_plan_.publish(toMessage(path.empty() ? planner.globalPath(here) : path, header()));
  }
  local_plan_.publish(toMessage(positions(report.decision.plan), header()));
  if (search_tree_.getNumSubscribers() > 0) {
    search_tree_.publish(treeMarkers(planner.viewTree(kMaxTreeEdges), symbol_size_, header()));
  }
}

void NavigationDisplay::showBeliefs(const CrowdBelief& crowd) {
  if (beliefs_.getNumSubscribers() > 0) {
    beliefs_.publish(toMessage(crowd, destinations_, header()));
  }
  if (belief_markers_.getNumSubscribers() == 0) return;
  // Not drawn under the lock, for which the end of a trip would have to wait, and commands with it.
  const std::vector<std::int64_t> attended = this->attended();
  belief_markers_.publish(beliefMarkers({crowd, destinations_, attended, symbol_size_}, header()));
}

std::vector<std::int64_t> NavigationDisplay::attended() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return attended_;
}

void NavigationDisplay::clearPlans() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    attended_.clear();
  }
  global_plan_.publish(toMessage(std::vector<Point>(), header()));
  local_plan_.publish(toMessage(std::vector<Point>(), header()));
  if (search_tree_.getNumSubscribers() == 0) return;
  search_tree_.publish(treeMarkers(TreeView(), symbol_size_, header()));
}

}  // namespace pomdp_crowd_nav
