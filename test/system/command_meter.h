// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <geometry_msgs/Twist.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>
#include <string>

#include "pomdp_crowd_nav/ros/steady_time.h"

namespace pomdp_crowd_nav {

// Times what comes on `cmd_vel`, of the robot in that namespace, in a thread of its own, so that
// nothing else in a test delays it.
class CommandMeter {
 public:
  struct Reading {
    int commands = 0;
    double longest_period = 0.0;                                   // [s] between two commands
    double least_speed = std::numeric_limits<double>::infinity();  // [m/s] commanded
  };

  explicit CommandMeter(const std::string& space = "") : node_(space), spinner_(1, &queue_) {
    node_.setCallbackQueue(&queue_);
    subscriber_ = node_.subscribe("cmd_vel", 100, &CommandMeter::onCommand, this,
                                  ros::TransportHints().tcpNoDelay());
    spinner_.start();
  }

  ~CommandMeter() { spinner_.stop(); }

  Reading reading() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return reading_;
  }

 private:
  void onCommand(const geometry_msgs::Twist& command) {
    const std::lock_guard<std::mutex> lock(mutex_);
    const double now = steadySeconds();
    if (reading_.commands > 0) {
      reading_.longest_period = std::max(reading_.longest_period, now - last_);
    }
    last_ = now;
    ++reading_.commands;
    reading_.least_speed =
        std::min(reading_.least_speed, std::hypot(command.linear.x, command.linear.y));
  }

  ros::NodeHandle node_;
  ros::CallbackQueue queue_;
  ros::AsyncSpinner spinner_;
  ros::Subscriber subscriber_;
  mutable std::mutex mutex_;
  Reading reading_;
  double last_ = 0.0;  // [s]
};

}  // namespace pomdp_crowd_nav
