// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>

#include "pomdp_crowd_nav/belief/belief_tracker.h"
#include "pomdp_crowd_nav/ros/conversions.h"
#include "pomdp_crowd_nav/ros/rate_meter.h"
#include "pomdp_crowd_nav/ros/stop_cause.h"
#include "pomdp_crowd_nav/ros/track_filter.h"
#include "pomdp_crowd_nav/world/static_map.h"

namespace pomdp_crowd_nav {

// What came in on one topic. All times [s], steady clock; negative: never.
struct InputTraffic {
  std::string topic;
  std::string frame;         // of the last message, good or bad
  RateMeter rate;            // of all messages
  double refused_at = -1.0;  // the last refusal
  MessageFault last_fault = MessageFault::kNone;
  std::array<unsigned, kMessageFaults> refused{};  // messages, by fault

  void noteArrival(const std::string& frame_id, double now);
  void noteRefusal(MessageFault fault, double now);
  unsigned count(MessageFault fault) const { return refused[static_cast<size_t>(fault)]; }
  unsigned refusals() const;
};

// What came in, and when. All times [s], steady clock; negative: never.
struct Inputs {
  std::optional<RobotReading> robot;
  TrackList tracks;
  CrowdBelief crowd;
  double tracks_at = -1.0;        // moment at which the newest tracks were measured
  double first_tracks_at = -1.0;  // of the present, unbroken series
  LeftOut left_out;               // of messages that were taken
  std::shared_ptr<const StaticMap> map;
  double map_at = -1.0;
  double clock_at = -1.0;  // ROS time was last seen to move on; negative: nobody watches it
  double jump_at = -1.0;
  StopCause jump = StopCause::kNone;  // kClockJumped or kPoseJumped
  unsigned clock_jumps = 0;
  InputTraffic odometry_traffic, people_traffic, map_traffic;

  // Tracks came in; a silence longer than `gap` [s] before them breaks the series, as one afresh
  // does.
  void noteTracks(double measured_at, double gap, bool is_afresh);
};

// Age limits, [s].
struct InputLimits {
  double odometry = 0.5;
  double people = 1.0;
  double map = 0.0;       // 0: none
  double clock = 0.5;     // ROS time that does not move on
  double watching = 1.0;  // unbroken tracks needed before the first decision
};

// The longest silence [s] in a series of tracks: a slow tracker may take up to its age limit.
double longestGap(double people_timeout);

// No base gets from one reading to the other; it was put elsewhere or found that it is.
bool isPoseJump(const RobotReading& from, const RobotReading& to, double max_speed);

// What is wrong with one input; kNone when it is fresh.
StopCause missingOdometry(const Inputs& inputs, const InputLimits& limits, double now);
StopCause missingPeople(const Inputs& inputs, const InputLimits& limits, double now);
StopCause missingMap(const Inputs& inputs, const InputLimits& limits, double now);
StopCause missingClock(const Inputs& inputs, const InputLimits& limits, double now);

// The first input that is missing or too old; kNone when the robot may drive.
StopCause missingInput(const Inputs& inputs, const InputLimits& limits, double now);

// The cause in words, with what is wrong with the messages where they are refused.
std::string explain(StopCause cause, const Inputs& inputs);

}  // namespace pomdp_crowd_nav
