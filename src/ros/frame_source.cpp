// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/ros/frame_source.h"

#include <chrono>
#include <thread>

#include "pomdp_crowd_nav/ros/conversions.h"
#include "pomdp_crowd_nav/ros/steady_time.h"

namespace pomdp_crowd_nav {
namespace {

constexpr double kWait = 0.05;  // [s], longest wait for a transform

FrameSource::Frame toFrame(const geometry_msgs::Transform& transform) {
  const std::optional<Pose> pose = toPose(transform);
  if (!pose) return {Pose{}, MessageFault::kBadTransform};
  return {*pose, MessageFault::kNone};
}

}  // namespace

std::string withoutSlash(const std::string& frame) {
  return frame.empty() || frame.front() != '/' ? frame : frame.substr(1);
}

FrameSource::Frame FrameSource::frameAt(const std::string& name, const ros::Time& stamp) const {
  const std::string frame = withoutSlash(name);
  const std::string global = withoutSlash(params_.global_frame);
  if (frame.empty()) return {Pose{}, MessageFault::kNoFrameName};
  if (frame == global) return {};
  const double give_up = steadySeconds() + kWait;
  while (true) {
    const Frame found = lookUp(global, frame, stamp);
    if (found.fault != MessageFault::kNoTransform) return found;
    if (steadySeconds() >= give_up) return newest(global, frame, stamp);
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
}

FrameSource::Frame FrameSource::frameIn(const std::string& target, const std::string& name,
                                        const ros::Time& stamp) const {
  const std::string frame = withoutSlash(name);
  const std::string other = withoutSlash(target);
  if (frame.empty()) return {Pose{}, MessageFault::kNoFrameName};
  if (frame == other) return {};
  const Frame found = lookUp(other, frame, stamp);
  return found.fault == MessageFault::kNoTransform ? newest(other, frame, stamp) : found;
}

FrameSource::Frame FrameSource::lookUp(Name target, Name frame, const ros::Time& stamp) const {
  try {
    std::string error;
    if (!buffer_.canTransform(target, frame, stamp, &error)) {
      return {Pose{}, MessageFault::kNoTransform};
    }
    return toFrame(buffer_.lookupTransform(target, frame, stamp).transform);
  } catch (const std::exception&) {  // tf2's own, and what a stamp out of range may raise
    return {Pose{}, MessageFault::kNoTransform};
  }
}

FrameSource::Frame FrameSource::newest(Name target, Name frame, const ros::Time& stamp) const {
  try {
    const auto transform = buffer_.lookupTransform(target, frame, ros::Time(0));
    const bool is_old = stamp.toSec() - transform.header.stamp.toSec() > params_.tolerance;
    if (is_old) return {Pose{}, MessageFault::kOldTransform};
    return toFrame(transform.transform);
  } catch (const std::exception&) {
    return {Pose{}, MessageFault::kNoTransform};
  }
}

}  // namespace pomdp_crowd_nav
