// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/time.h>
#include <tf2_ros/buffer.h>

#include <string>

#include "pomdp_crowd_nav/ros/stop_cause.h"
#include "pomdp_crowd_nav/ros/transform_feed.h"
#include "pomdp_crowd_nav/world/geometry.h"

namespace pomdp_crowd_nav {

// Where frames are in the global frame. Thread-safe, never throws.
class FrameSource {
 public:
  struct Params {
    std::string global_frame = "map";
    double tolerance = 0.2;  // [s], a transform may be this much older than its message
  };

  explicit FrameSource(Params params) : params_(std::move(params)), feed_(buffer_) {}

  struct Frame {
    Pose pose;
    MessageFault fault = MessageFault::kNone;  // why there is no pose
  };

  // The frame at `stamp`, waiting for it a little; else the newest one if it is not older than the
  // tolerance. A leading slash, as of older publishers, does not count.
  Frame frameAt(const std::string& name, const ros::Time& stamp) const;

  // The same in another frame, without waiting.
  Frame frameIn(const std::string& target, const std::string& name, const ros::Time& stamp) const;

  // Forgets all transforms, for time that runs backwards.
  void clear() { buffer_.clear(); }

  const std::string& globalFrame() const { return params_.global_frame; }

 private:
  using Name = const std::string&;
  Frame lookUp(Name target, Name frame, const ros::Time& stamp) const;
  Frame newest(Name target, Name frame, const ros::Time& stamp) const;

  Params params_;
  tf2_ros::Buffer buffer_;
  TransformFeed feed_;
};

// The name without the slash in front that tf2 does not know.
std::string withoutSlash(const std::string& frame);

}  // namespace pomdp_crowd_nav
