// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <geometry_msgs/TransformStamped.h>
#include <rosbag/bag.h>
#include <tf2/buffer_core.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "pomdp_crowd_nav/world/geometry.h"

namespace pomdp_crowd_nav {

// The transforms in /tf and /tf_static of a bag. To be asked in order of time: tf2 looks one by one
// through all that it holds, so it is given some seconds at a time.
class BagTransforms {
 public:
  explicit BagTransforms(const rosbag::Bag& bag);

  // Pose of `frame` in `target` at that time; none where the bag does not say it.
  std::optional<Pose> find(const std::string& target, const std::string& frame,
                           const ros::Time& stamp);

 private:
  void feedUntil(double time);  // [s]

  tf2::BufferCore buffer_;
  std::vector<geometry_msgs::TransformStamped> moving_;  // of /tf, in order of time
  std::size_t fed_ = 0;
};

}  // namespace pomdp_crowd_nav
