// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/ros/map_input.h"

#include <ros/console.h>

#include <stdexcept>

#include "pomdp_crowd_nav/ros/frame_source.h"
#include "pomdp_crowd_nav/ros/steady_time.h"

namespace pomdp_crowd_nav {

MapInput::MapInput(ros::NodeHandle& node, const PlannerNodeParams& params, Guarded<Drive>& drive)
    : global_frame_(params.frames.global), policy_(params.map), drive_(drive) {
  const std::string topic = node.resolveName("map");
  drive_.with([&](Drive& shared) { shared.inputs.map_traffic.topic = topic; });
  if (!params.world_file.empty()) {
    world_map_ = std::make_shared<const StaticMap>(loadWorld(params.world_file).map());
    useMap(world_map_);
  }
  constexpr int kQueue = 1;  // only the newest message counts
  subscriber_ = node.subscribe("map", kQueue, &MapInput::onMap, this);
}

void MapInput::onMap(const nav_msgs::OccupancyGrid& grid) {
  drive_.with([&](Drive& drive) {
    drive.inputs.map_traffic.noteArrival(grid.header.frame_id, steadySeconds());
  });
  const bool same = grid.info.origin == last_grid_.info.origin && grid.data == last_grid_.data &&
                    grid.info.resolution == last_grid_.info.resolution &&
                    grid.info.width == last_grid_.info.width;
  if (withoutSlash(grid.header.frame_id) != withoutSlash(global_frame_)) {
    ROS_ERROR("map: its frame must be '%s', got '%s'", global_frame_.c_str(),
              grid.header.frame_id.c_str());
    return refuse(MessageFault::kNoTransform);
  }
  if (same) return drive_.with([](Drive& drive) { drive.inputs.map_at = steadySeconds(); });
  try {
    const bool is_world = world_map_ && isDrawingOf(*world_map_, grid, policy_);
    if (world_map_ && !is_world) ROS_INFO("the map on the topic is used, not the world file's");
    useMap(is_world ? world_map_ : toStaticMap(grid, policy_));
    last_grid_ = grid;
  } catch (const std::exception& error) {
    ROS_ERROR("%s", error.what());
    refuse(MessageFault::kMalformed);
  }
}

void MapInput::useMap(std::shared_ptr<const StaticMap> map) {
  drive_.with([&](Drive& drive) {
    drive.inputs.map.swap(map);
    drive.inputs.map_at = steadySeconds();
  });
}

void MapInput::refuse(MessageFault fault) {
  drive_.with([&](Drive& drive) { drive.inputs.map_traffic.noteRefusal(fault, steadySeconds()); });
}

}  // namespace pomdp_crowd_nav
