// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <std_msgs/Header.h>

#include <functional>

#include "pomdp_crowd_nav/ros/clock_watch.h"
#include "pomdp_crowd_nav/ros/frame_source.h"

namespace pomdp_crowd_nav {

// Stamp of the newest message of a topic that was taken, and when the clock jumped last before it.
struct NewestStamp {
  long epoch = -1;
  double stamp = 0.0;  // [s]
};

// What the header of a message is worth.
struct HeaderVerdict {
  MessageFault fault = MessageFault::kNone;
  double stamp = 0.0;        // [s]
  double measured_at = 0.0;  // [s], steady clock
  long epoch = 0;
  Pose frame;  // in the global frame

  NewestStamp newest() const { return {epoch, stamp}; }
};

// Judges stamps against the clock and brings frames into the global frame. Thread-safe, never
// throws.
class MessageGate {
 public:
  // [s] a stamp may be ahead of the clock, as between machines; it is then taken as now.
  static constexpr double kFutureSlack = 0.5;

  // `on_jump` is called when the clock jumped, before the message that met it is judged.
  MessageGate(FrameSource& frames, ClockWatch& clock, std::function<void()> on_jump)
      : frames_(frames), clock_(clock), on_jump_(std::move(on_jump)) {}

  HeaderVerdict judge(const std_msgs::Header& header, const NewestStamp& newest) const;

  // Whether the clock has jumped since the message was judged.
  bool isOutdated(const HeaderVerdict& verdict) const { return verdict.epoch != clock_.epoch(); }

 private:
  FrameSource& frames_;
  ClockWatch& clock_;
  std::function<void()> on_jump_;
};

// What is wrong with a stamp [s] at ROS time `now` [s], whatever its frame.
MessageFault faultOfStamp(double stamp, double now, const NewestStamp& newest, long epoch);

}  // namespace pomdp_crowd_nav
