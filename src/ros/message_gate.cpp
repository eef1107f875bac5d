// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/ros/message_gate.h"

#include <algorithm>

namespace pomdp_crowd_nav {

// In seconds: the difference of two ros::Time throws where it does not fit into a ros::Duration.
MessageFault faultOfStamp(double stamp, double now, const NewestStamp& newest, long epoch) {
  if (stamp <= 0.0) return MessageFault::kUnstamped;
  if (stamp > now + MessageGate::kFutureSlack) return MessageFault::kFuture;
  if (newest.epoch == epoch && stamp < newest.stamp) return MessageFault::kOutOfOrder;
  return MessageFault::kNone;
}

HeaderVerdict MessageGate::judge(const std_msgs::Header& header, const NewestStamp& newest) const {
  const ClockWatch::Look look = clock_.look();
  if (look.jumped) on_jump_();
  HeaderVerdict verdict;
  verdict.epoch = look.epoch;
  verdict.stamp = header.stamp.toSec();
  // A stamp of the future is now.
  verdict.measured_at = look.now - std::max(0.0, look.ros_time - verdict.stamp);
  verdict.fault = faultOfStamp(verdict.stamp, look.ros_time, newest, look.epoch);
  if (verdict.fault != MessageFault::kNone) return verdict;
  const bool is_ahead = verdict.stamp > look.ros_time;
  const FrameSource::Frame frame =
      frames_.frameAt(header.frame_id, is_ahead ? ros::Time(look.ros_time) : header.stamp);
  verdict.frame = frame.pose;
  verdict.fault = frame.fault;
  return verdict;
}

}  // namespace pomdp_crowd_nav
