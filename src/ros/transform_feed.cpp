// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/ros/transform_feed.h"

#include <exception>

namespace pomdp_crowd_nav {

bool isTransformOfUse(double stamp, double now) {
  return stamp <= now + TransformFeed::kFutureSlack;
}

TransformFeed::TransformFeed(tf2_ros::Buffer& buffer) : buffer_(buffer), spinner_(1, &queue_) {
  constexpr int kQueue = 100;  // messages
  ros::NodeHandle node;
  node.setCallbackQueue(&queue_);
  const auto subscribe = [&](const char* topic, bool is_static) {
    const boost::function<void(const Event&)> callback = [this, is_static](const Event& event) {
      onTransforms(event, is_static);
    };
    return node.subscribe<tf2_msgs::TFMessage, const Event&>(topic, kQueue, callback);
  };
  moving_ = subscribe("/tf", false);
  fixed_ = subscribe("/tf_static", true);
  spinner_.start();
}

TransformFeed::~TransformFeed() { spinner_.stop(); }

void TransformFeed::onTransforms(const Event& event, bool is_static) {
  const double now = ros::Time::now().toSec();
  const std::string publisher = event.getPublisherName();
  for (const geometry_msgs::TransformStamped& transform : event.getConstMessage()->transforms) {
    if (!is_static && !isTransformOfUse(transform.header.stamp.toSec(), now)) {
      ROS_WARN_THROTTLE(5.0, "a transform from '%s' to '%s' is passed over: stamped in the future",
                        transform.header.frame_id.c_str(), transform.child_frame_id.c_str());
      continue;
    }
    try {
      buffer_.setTransform(transform, publisher, is_static);
    } catch (const std::exception& error) {
      ROS_WARN_THROTTLE(5.0, "a transform is passed over: %s", error.what());
    }
  }
}

}  // namespace pomdp_crowd_nav
