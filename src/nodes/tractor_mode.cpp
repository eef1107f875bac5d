// SPDX-License-Identifier: BSD-3-Clause
#include <ros/ros.h>

#include <iostream>

#include "pomdp_crowd_nav/ros/node_arguments.h"
#include "pomdp_crowd_nav/ros/tractor_mode_request.h"

int main(int argc, char** argv) {
  ros::init(argc, argv, "tractor_mode");
  const auto status = pomdp_crowd_nav::answerArguments(
      "tractor_mode", "Asks the base of a Kinova MOVO for the mode in which it drives.", argc,
      argv);
  if (status) return *status;
  try {
    ros::NodeHandle node;
    constexpr double kFrequency = 5.0;  // [Hz]
    const pomdp_crowd_nav::TractorModeRequest request(node, kFrequency);
    ros::spin();
  } catch (const std::exception& error) {
    std::cerr << "tractor_mode: " << error.what() << std::endl;
    return 2;
  }
  return 0;
}
