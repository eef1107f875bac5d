// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/ros/tractor_mode_request.h"

#include "pomdp_crowd_nav/ros/steady_time.h"

namespace pomdp_crowd_nav {
namespace {

constexpr std::uint32_t kTractorMode = 5;  // as requested and as reported
constexpr double kStatusTimeout = 1.0;     // [s]

}  // namespace

TractorModeRequest::TractorModeRequest(ros::NodeHandle& node, double frequency)
    : requests_(node.advertise<ConfigCmd>("gp_command", 1)),
      status_(node.subscribe("status", 1, &TractorModeRequest::onStatus, this)) {
  ros::SteadyTimerOptions options;
  options.period = ros::WallDuration(1.0 / frequency);
  options.callback = [this](const ros::SteadyTimerEvent&) { onTimer(); };
  options.callback_queue = nullptr;
  timer_ = node.createSteadyTimer(options);
}

void TractorModeRequest::onStatus(const MovoStatus& status) {
  const bool is_in_mode = status.operational_state == kTractorMode;
  if (is_in_mode && !is_in_mode_) ROS_INFO("the base is in tractor mode");
  if (!is_in_mode && is_in_mode_) {
    ROS_WARN("the base has left tractor mode, its state is %u; restart this node to ask again",
             status.operational_state);
  }
  is_in_mode_ = is_in_mode;
  has_been_in_mode_ = has_been_in_mode_ || is_in_mode;
  status_at_ = steadySeconds();
}

void TractorModeRequest::onTimer() {
  if (has_been_in_mode_) return;
  if (status_at_ < 0.0 || steadySeconds() - status_at_ > kStatusTimeout) {
    ROS_WARN_THROTTLE(10.0, "no status of the base on %s", status_.getTopic().c_str());
    return;
  }
  ROS_INFO_THROTTLE(10.0, "asking the base for tractor mode");
  ConfigCmd request;
  request.header.stamp = ros::Time::now();
  request.gp_cmd = "GENERAL_PURPOSE_CMD_SET_OPERATIONAL_MODE";
  request.gp_param = kTractorMode;
  requests_.publish(request);
}

}  // namespace pomdp_crowd_nav
