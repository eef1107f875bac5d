// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nav_msgs/OccupancyGrid.h>
#include <ros/node_handle.h>

#include "pomdp_crowd_nav/ros/drive.h"
#include "pomdp_crowd_nav/ros/guarded.h"
#include "pomdp_crowd_nav/ros/map_conversions.h"

namespace pomdp_crowd_nav {

// The topic `map`.
//
// A world file's map holds until the topic says something else, as it does when the simulator is
// reset to another world; a grid that only repeats it more coarsely changes nothing.
class MapInput {
 public:
  MapInput(ros::NodeHandle& node, const PlannerNodeParams& params, Guarded<Drive>& drive);

 private:
  void onMap(const nav_msgs::OccupancyGrid& grid);
  void useMap(std::shared_ptr<const StaticMap> map);
  void refuse(MessageFault fault);

  std::string global_frame_;
  MapPolicy policy_;
  Guarded<Drive>& drive_;
  std::shared_ptr<const StaticMap> world_map_;  // the world file's, if there is one
  nav_msgs::OccupancyGrid last_grid_;
  ros::Subscriber subscriber_;
};

}  // namespace pomdp_crowd_nav
