// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nav_msgs/OccupancyGrid.h>
#include <ros/node_handle.h>
#include <tf2_ros/buffer.h>
#include <tf2_ros/transform_listener.h>

#include <optional>
#include <string>

#include "pomdp_crowd_nav/ros/drive.h"
#include "pomdp_crowd_nav/ros/guarded.h"

namespace pomdp_crowd_nav {

// Brings odometry, tracked people and the map into the global frame and into the shared state.
//
// A message whose frame cannot be transformed, or with a number that is not finite, is dropped and
// counted: its input then ages, and the robot stops when it is too old. When ROS time jumps back
// or the robot is suddenly elsewhere, everything measured before is forgotten.
//
// A world file's map holds until the topic `map` says something else, as it does when the simulator
// is reset to another world; a grid that only repeats it more coarsely changes nothing.
class InputListener {
 public:
  InputListener(ros::NodeHandle& node, const PlannerNodeParams& params, Guarded<Drive>& drive);

  // Pose of `frame` in the global frame at `stamp`, waiting for it a little; else the newest one if
  // it is not older than the tolerance. None for a frame that is not known.
  std::optional<Pose> frameAt(const std::string& frame, const ros::Time& stamp);

  const std::vector<Point>& destinations() const { return tracker_.destinations(); }

 private:
  void onOdometry(const nav_msgs::Odometry& odometry);
  void onPersons(const TrackedPersons& persons);
  void onMap(const nav_msgs::OccupancyGrid& grid);
  void useMap(std::shared_ptr<const StaticMap> map);

  std::optional<Pose> lookUp(const std::string& frame, const ros::Time& stamp) const;
  void countTransformFailure(const std::string& frame);
  void noticeClockJump(const ros::Time& now);
  void noticePoseJump(const RobotReading& reading);
  void forgetEverything();

  std::string global_frame_;
  ros::Duration tolerance_;
  double max_speed_;  // [m/s]
  Guarded<Drive>& drive_;
  tf2_ros::Buffer buffer_;
  tf2_ros::TransformListener transforms_;
  BeliefTracker tracker_;                       // touched under the lock of drive_ only
  ros::Time last_time_;                         // touched under the lock of drive_ only
  std::shared_ptr<const StaticMap> world_map_;  // the world file's, if there is one
  nav_msgs::OccupancyGrid last_grid_;
  MapPolicy map_policy_;
  ros::Subscriber odometry_, persons_, map_;
};

}  // namespace pomdp_crowd_nav
