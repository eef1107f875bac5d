// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/ros/odometry_input.h"

#include <ros/console.h>

#include <cmath>

#include "pomdp_crowd_nav/ros/steady_time.h"

namespace pomdp_crowd_nav {

ReadingRange readingRange(const VehicleParams& vehicle) {
  constexpr double kTimes = 5.0;  // a base that is pushed or slips stays below
  ReadingRange range;
  range.speed = kTimes * vehicle.max_speed;
  range.yaw_rate = kTimes * vehicle.max_yaw_rate;
  return range;
}

bool isWithin(const RobotReading& reading, const ReadingRange& range) {
  return reading.pose.position.cwiseAbs().maxCoeff() <= range.position &&
         reading.velocity.norm() <= range.speed && std::abs(reading.yaw_rate) <= range.yaw_rate;
}

OdometryInput::OdometryInput(ros::NodeHandle& node, const VehicleParams& vehicle,
                             const MessageGate& gate, Guarded<Drive>& drive,
                             std::function<void()> on_jump)
    : vehicle_(vehicle),
      range_(readingRange(vehicle)),
      gate_(gate),
      drive_(drive),
      on_jump_(std::move(on_jump)) {
  const std::string topic = node.resolveName("odom");
  drive_.with([&](Drive& shared) { shared.inputs.odometry_traffic.topic = topic; });
  constexpr int kQueue = 1;  // only the newest message counts
  subscriber_ = node.subscribe("odom", kQueue, &OdometryInput::onOdometry, this,
                               ros::TransportHints().tcpNoDelay());
}

void OdometryInput::onOdometry(const nav_msgs::Odometry& odometry) {
  drive_.with([&](Drive& drive) {
    drive.inputs.odometry_traffic.noteArrival(odometry.header.frame_id, steadySeconds());
  });
  const HeaderVerdict verdict = gate_.judge(odometry.header, newest_);
  if (verdict.fault != MessageFault::kNone) return refuse(verdict.fault);
  std::optional<RobotReading> reading = toReading(odometry, verdict.frame);
  if (!reading) return refuse(MessageFault::kNotFinite);
  if (!isWithin(*reading, range_)) return refuse(MessageFault::kOutOfRange);
  reading->measured_at = verdict.measured_at;
  take(*reading, verdict);
}

void OdometryInput::take(const RobotReading& reading, const HeaderVerdict& verdict) {
  const bool jumped = drive_.with([&](Drive& drive) {
    const std::optional<RobotReading>& last = drive.inputs.robot;
    return last && isPoseJump(*last, reading, vehicle_.max_speed);
  });
  if (jumped) on_jump_();
  if (gate_.isOutdated(verdict)) return;
  newest_ = verdict.newest();
  drive_.with([&](Drive& drive) { drive.inputs.robot = reading; });
}

void OdometryInput::refuse(MessageFault fault) {
  drive_.with(
      [&](Drive& drive) { drive.inputs.odometry_traffic.noteRefusal(fault, steadySeconds()); });
  ROS_WARN_THROTTLE(1.0, "odometry is refused: %s", describe(fault));
}

}  // namespace pomdp_crowd_nav
