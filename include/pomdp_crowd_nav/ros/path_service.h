// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nav_msgs/GetPlan.h>
#include <ros/node_handle.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "pomdp_crowd_nav/planner/map_work.h"
#include "pomdp_crowd_nav/ros/drive.h"
#include "pomdp_crowd_nav/ros/guarded.h"

namespace pomdp_crowd_nav {

// The service `~make_plan`: the way from one place to another if nobody were about, whatever trip
// is under way. It costs the work of a goal, not that of the map.
class PathService {
 public:
  // Brings a place into the global frame, or says in `reason` why the robot cannot stand there.
  using Check = std::function<std::optional<Pose>(const geometry_msgs::PoseStamped&, std::string&)>;

  // `drive` and `map_work` must outlive the service.
  PathService(ros::NodeHandle& private_node, const PlannerNodeParams& params, Guarded<Drive>& drive,
              MapWork& map_work, Check check);

 private:
  bool onRequest(nav_msgs::GetPlan::Request& request, nav_msgs::GetPlan::Response& response);
  std::vector<Point> findPath(const nav_msgs::GetPlan::Request& request, std::string& reason);

  std::string global_frame_;
  std::vector<Point> destinations_;
  Guarded<Drive>& drive_;
  MapWork& map_work_;
  Check check_;
  ros::ServiceServer server_;
};

}  // namespace pomdp_crowd_nav
