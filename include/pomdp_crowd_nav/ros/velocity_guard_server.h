// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <diagnostic_updater/diagnostic_updater.h>
#include <geometry_msgs/Twist.h>
#include <nav_msgs/Odometry.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>

#include <array>
#include <atomic>
#include <optional>
#include <string>

#include "pomdp_crowd_nav/control/velocity_guard.h"
#include "pomdp_crowd_nav/params/load_params.h"
#include "pomdp_crowd_nav/ros/frame_source.h"
#include "pomdp_crowd_nav/ros/guarded.h"
#include "pomdp_crowd_nav/ros/messages.h"

namespace pomdp_crowd_nav {

// Reads a profile from the whole namespace; throws with one line for an unknown key or a value that
// is not allowed.
NavigationParams loadGuardNodeParams(ParamReader& reader);

// The guard node: a VelocityGuard between the planner's commands and the base.
//
// A timer on the steady clock with a thread of its own sends commands, whatever else happens in the
// node. People of both topics, `tracked_persons` and `people`, are brought into the frame in which
// odometry is given; a message whose stamp, frame or numbers make no sense is refused, counted and
// named.
class VelocityGuardServer {
 public:
  VelocityGuardServer(ros::NodeHandle node, ros::NodeHandle private_node,
                      const NavigationParams& params);
  ~VelocityGuardServer();

  // For the end of the node: waits until the base is braked or the braking time has passed, and
  // leaves a zero as the last command of a base that was driven.
  void stopBase();

 private:
  struct State {
    VelocityGuard guard;
    VelocityGuard::Output output;
    std::string odom_frame;                    // empty before the first odometry
    double last_time = 0.0;                    // [s], ROS time, to notice jumps
    GuardStatus counts;                        // only its counts are used
    std::string odometry_fault, people_fault;  // of the last message that was refused

    explicit State(const VelocityGuard& velocity_guard) : guard(velocity_guard) {}
  };

  void onCommand(const geometry_msgs::Twist& twist);
  void onOdometry(const nav_msgs::Odometry& odometry);
  template <class Message>
  void onPeople(size_t source, const Message& message);
  void onCommandTimer();
  void onReportTimer();

  void takeOdometry(const nav_msgs::Odometry& odometry, double measured_at);
  void refuseOdometry(MessageFault fault);
  void refusePeople(size_t source, const std_msgs::Header& header, MessageFault fault);
  void noticeClockJump(double now);
  static std::string causeOf(GuardCause cause, const State& state);
  GuardStatus status();
  void diagnose(diagnostic_updater::DiagnosticStatusWrapper& out);

  double braking_time_;  // [s], from full speed
  Guarded<State> state_;
  std::atomic<bool> is_sending_{false};
  GuardCause last_cause_ = GuardCause::kNone;  // touched by the command timer only
  std::uint8_t last_state_ = 0;                // the same
  long reports_ = 0;

  FrameSource frames_;
  ros::Publisher commands_, statuses_;
  ros::Subscriber raw_commands_, odometry_;
  std::array<ros::Subscriber, VelocityGuard::kSources> people_;
  diagnostic_updater::Updater diagnostics_;

  ros::CallbackQueue command_queue_;
  ros::AsyncSpinner command_spinner_;
  ros::SteadyTimer command_timer_, report_timer_;
};

}  // namespace pomdp_crowd_nav
