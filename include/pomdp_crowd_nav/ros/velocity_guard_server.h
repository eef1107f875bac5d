// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <diagnostic_updater/diagnostic_updater.h>
#include <geometry_msgs/Twist.h>
#include <nav_msgs/Odometry.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <tf2_ros/buffer.h>
#include <tf2_ros/transform_listener.h>

#include <atomic>
#include <optional>
#include <string>

#include "pomdp_crowd_nav/control/velocity_guard.h"
#include "pomdp_crowd_nav/params/load_params.h"
#include "pomdp_crowd_nav/ros/guarded.h"
#include "pomdp_crowd_nav/ros/messages.h"

namespace pomdp_crowd_nav {

// Reads a profile from the whole namespace; throws with one line for an unknown key or a value that
// is not allowed.
NavigationParams loadGuardNodeParams(ParamReader& reader);

// The guard node: a VelocityGuard between the planner's commands and the base.
//
// A timer on the steady clock with a thread of its own sends commands, whatever else happens in the
// node. People are brought into the frame in which odometry is given; a message whose frame cannot
// be transformed, or with a number that is not finite, is dropped and counted.
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
    std::string odom_frame;  // empty before the first odometry
    ros::Time last_time;     // ROS time, to notice jumps
    GuardStatus counts;      // only its counts are used

    explicit State(const VelocityGuard& velocity_guard) : guard(velocity_guard) {}
  };

  void onCommand(const geometry_msgs::Twist& twist);
  void onOdometry(const nav_msgs::Odometry& odometry);
  void onPersons(const TrackedPersons& persons);
  void onCommandTimer();
  void onReportTimer();

  std::optional<Pose> frameOf(const std_msgs::Header& header, const std::string& target) const;
  void noticeClockJump(const ros::Time& now);
  GuardStatus status();
  void diagnose(diagnostic_updater::DiagnosticStatusWrapper& out);

  double braking_time_;  // [s], from full speed
  ros::Duration tolerance_;
  Guarded<State> state_;
  std::atomic<bool> is_sending_{false};
  GuardCause last_cause_ = GuardCause::kNone;  // touched by the command timer only
  std::uint8_t last_state_ = 0;                // the same
  long reports_ = 0;

  tf2_ros::Buffer buffer_;
  tf2_ros::TransformListener transforms_;
  ros::Publisher commands_, statuses_;
  ros::Subscriber raw_commands_, odometry_, persons_;
  diagnostic_updater::Updater diagnostics_;

  ros::CallbackQueue command_queue_;
  ros::AsyncSpinner command_spinner_;
  ros::SteadyTimer command_timer_, report_timer_;
};

}  // namespace pomdp_crowd_nav
