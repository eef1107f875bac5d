// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/ros/path_service.h"

#include <ros/console.h>

#include <utility>

#include "pomdp_crowd_nav/evaluation/reachability.h"
#include "pomdp_crowd_nav/planner/planner_factory.h"

namespace pomdp_crowd_nav {

PathService::PathService(ros::NodeHandle& private_node, const PlannerNodeParams& params,
                         Guarded<Drive>& drive, MapWork& map_work, Check check)
    : global_frame_(params.frames.global),
      destinations_(params.destinations),
      drive_(drive),
      map_work_(map_work),
      check_(std::move(check)) {
  server_ = private_node.advertiseService("make_plan", &PathService::onRequest, this);
}

bool PathService::onRequest(nav_msgs::GetPlan::Request& request,
                            nav_msgs::GetPlan::Response& response) {
  std::string reason;
  std::vector<Point> path;
  try {
    path = findPath(request, reason);
  } catch (const std::exception& error) {
    reason = error.what();
  }
  if (!reason.empty()) {
    ROS_WARN("make_plan: %s", reason.c_str());
    return false;
  }
  std_msgs::Header header;
  header.frame_id = global_frame_;
  header.stamp = ros::Time::now();
  response.plan = toMessage(path, header);
  return true;
}

std::vector<Point> PathService::findPath(const nav_msgs::GetPlan::Request& request,
                                         std::string& reason) {
  const std::optional<Pose> start = check_(request.start, reason);
  const std::optional<Pose> goal = start ? check_(request.goal, reason) : std::nullopt;
  const auto [map, params] =
      drive_.with([](Drive& drive) { return std::make_pair(drive.inputs.map, drive.params); });
  if (goal && !map) reason = "no map yet";
  if (!reason.empty()) return {};
  NavigationParams navigation = *params;
  // No decision is made with it, so it needs no table for a tight bound.
  navigation.planning.model.upper_bound = UpperBoundKind::kPaper;
  const Task task{*map, goal->position, destinations_, nullptr, map_work_.of(map)};
  const auto planner = makePlanner(navigation.planner, task, navigation.planning);
  reason = whyNoWay(*planner, {start->position, goal->position}, *map, navigation.planning.model);
  return planner->globalPath(start->position);
}

}  // namespace pomdp_crowd_nav
