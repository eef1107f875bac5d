// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <tf2_msgs/TFMessage.h>
#include <tf2_ros/buffer.h>

namespace pomdp_crowd_nav {

// Fills a buffer from /tf and /tf_static, in a thread of its own, as tf2_ros::TransformListener
// does.
//
// A transform of the far future is passed over: tf2 would prefer it to all that come after it, and
// of one stamped at the end of time it throws what ends the process.
class TransformFeed {
 public:
  // [s] a stamp may be ahead of the clock; localisations stamp theirs ahead on purpose.
  static constexpr double kFutureSlack = 10.0;

  // `buffer` must outlive the feed.
  explicit TransformFeed(tf2_ros::Buffer& buffer);
  ~TransformFeed();

 private:
  using Event = ros::MessageEvent<tf2_msgs::TFMessage const>;
  void onTransforms(const Event& event, bool is_static);

  tf2_ros::Buffer& buffer_;
  ros::CallbackQueue queue_;
  ros::Subscriber moving_, fixed_;
  ros::AsyncSpinner spinner_;
};

// Whether a transform stamped so [s] is of use at ROS time `now` [s].
bool isTransformOfUse(double stamp, double now);

}  // namespace pomdp_crowd_nav
