// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/ros/message_gate.h"

#include <algorithm>

#include "pomdp_crowd_nav/ros/steady_time.h"

namespace pomdp_crowd_nav {

// In seconds: the difference of two ros::Time throws where it does not fit into a ros::Duration.
MessageFault faultOfStamp(double stamp, double now, const NewestStamp& newest, long epoch) {
  if (stamp <= 0.0) return MessageFault::kUnstamped;
  if (stamp > now + MessageGate::kFutureSlack) return MessageFault::kFuture;
  if (newest.epoch == epoch && stamp < newest.stamp) return MessageFault::kOutOfOrder;
  return MessageFault::kNone;
}

HeaderVerdict MessageGate::judge(const std_msgs::Header& header, const NewestStamp& newest) const {
  const ros::Time ros_now = ros::Time::now();
  const double now = steadySeconds();
  const ClockWatch::Look look = clock_.look(ros_now.toSec(), now);
  if (look.jumped) on_jump_();
  HeaderVerdict verdict;
  verdict.epoch = look.epoch;
  verdict.stamp = header.stamp.toSec();
  // A stamp of the future is now.
  verdict.measured_at = now - std::max(0.0, ros_now.toSec() - verdict.stamp);
  verdict.fault = faultOfStamp(verdict.stamp, ros_now.toSec(), newest, look.epoch);
  if (verdict.fault != MessageFault::kNone) return verdict;
  const FrameSource::Frame frame =
      frames_.frameAt(header.frame_id, std::min(header.stamp, ros_now));
  verdict.frame = frame.pose;
  verdict.fault = frame.fault;
  return verdict;
}

}  // namespace pomdp_crowd_nav
