// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/ros/bag_transforms.h"

#include <rosbag/view.h>
#include <tf2/exceptions.h>
#include <tf2_msgs/TFMessage.h>

#include <algorithm>
#include <tuple>

#include "pomdp_crowd_nav/ros/conversions.h"

namespace pomdp_crowd_nav {
namespace {

constexpr double kAhead = 30.0;   // [s] of transforms after a moment that are looked at
constexpr double kMemory = 60.0;  // [s] that tf2 holds
constexpr const char* kAuthority = "bag";

using Transform = geometry_msgs::TransformStamped;

std::vector<Transform> transformsOn(const rosbag::Bag& bag, const std::string& topic) {
  rosbag::View view(bag, rosbag::TopicQuery({topic, "/" + topic}));
  std::vector<Transform> transforms;
  for (const rosbag::MessageInstance& instance : view) {
    const auto message = instance.instantiate<tf2_msgs::TFMessage>();
    if (!message) continue;
    transforms.insert(transforms.end(), message->transforms.begin(), message->transforms.end());
  }
  return transforms;
}

// The same again is nothing new, but tf2 warns of it.
void sortByTime(std::vector<Transform>& transforms) {
  const auto key = [](const Transform& it) { return std::tie(it.header.stamp, it.child_frame_id); };
  std::stable_sort(transforms.begin(), transforms.end(),
                   [&](const Transform& a, const Transform& b) { return key(a) < key(b); });
  const auto end =
      std::unique(transforms.begin(), transforms.end(),
                  [&](const Transform& a, const Transform& b) { return key(a) == key(b); });
  transforms.erase(end, transforms.end());
}

}  // namespace

BagTransforms::BagTransforms(const rosbag::Bag& bag)
    : buffer_(ros::Duration(kMemory)), moving_(transformsOn(bag, "tf")) {
  for (const Transform& fixed : transformsOn(bag, "tf_static")) {
    buffer_.setTransform(fixed, kAuthority, true);
  }
  sortByTime(moving_);
}

std::optional<Pose> BagTransforms::find(const std::string& target, const std::string& frame,
                                        const ros::Time& stamp) {
  if (stamp.isZero()) return std::nullopt;  // to tf2 that is the newest
  feedUntil(stamp.toSec() + kAhead);
  try {
    return toPose(buffer_.lookupTransform(target, frame, stamp).transform);
  } catch (const tf2::TransformException&) {
    return std::nullopt;
  }
}

void BagTransforms::feedUntil(double time) {
  for (; fed_ < moving_.size() && moving_[fed_].header.stamp.toSec() <= time; ++fed_) {
    buffer_.setTransform(moving_[fed_], kAuthority);
  }
}

}  // namespace pomdp_crowd_nav
