// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/ros.h>

#include "pomdp_crowd_nav/ros/messages.h"

namespace pomdp_crowd_nav {

// Asks the base of a Kinova MOVO for the mode in which it follows velocity commands, again and
// again until its status says that it is in it.
//
// A base that leaves the mode later has been stopped by somebody: that is said, and it is not asked
// again.
class TractorModeRequest {
 public:
  // `frequency` [Hz] of the request.
  TractorModeRequest(ros::NodeHandle& node, double frequency);

 private:
  void onStatus(const MovoStatus& status);
  void onTimer();

  bool has_been_in_mode_ = false;
  bool is_in_mode_ = false;
  double status_at_ = -1.0;  // [s], steady clock; negative: never
  ros::Publisher requests_;
  ros::Subscriber status_;
  ros::SteadyTimer timer_;
};

}  // namespace pomdp_crowd_nav
