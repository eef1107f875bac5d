// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/ros/input_listener.h"

#include <ros/console.h>

#include "pomdp_crowd_nav/ros/steady_time.h"

namespace pomdp_crowd_nav {
namespace {

constexpr double kClockPeriod = 0.05;  // [s] between two looks at the clock

}  // namespace

InputListener::InputListener(ros::NodeHandle& node, const PlannerNodeParams& params,
                             Guarded<Drive>& drive)
    : drive_(drive),
      frames_({params.frames.global, params.navigation.transform_tolerance}),
      gate_(frames_, clock_, [this] { onClockJump(); }),
      people_(node, params, gate_, drive),
      odometry_(node, params.navigation.planning.model.vehicle, gate_, drive,
                [this] { startAfresh(StopCause::kPoseJumped); }),
      map_(node, params, drive) {
  watchClock();
  clock_timer_ = node.createSteadyTimer(ros::WallDuration(kClockPeriod),
                                        [this](const ros::SteadyTimerEvent&) { watchClock(); });
}

std::optional<Pose> InputListener::frameAt(const std::string& frame, const ros::Time& stamp) {
  const FrameSource::Frame found = frames_.frameAt(frame, stamp);
  return found.fault == MessageFault::kNone ? std::optional<Pose>(found.pose) : std::nullopt;
}

void InputListener::watchClock() {
  const ClockWatch::Look look = clock_.look();
  if (look.jumped) onClockJump();
  drive_.with([&](Drive& drive) { drive.inputs.clock_at = look.moved_at; });
}

void InputListener::onClockJump() {
  frames_.clear();
  startAfresh(StopCause::kClockJumped);
}

void InputListener::startAfresh(StopCause jump) {
  ROS_WARN("%s: beliefs are forgotten and the base is stopped", describe(jump));
  people_.forget();
  drive_.with([&](Drive& drive) {
    drive.inputs.jump_at = steadySeconds();
    drive.inputs.jump = jump;
    if (jump == StopCause::kClockJumped) ++drive.inputs.clock_jumps;
    drive.executor.stop();
  });
}

}  // namespace pomdp_crowd_nav
