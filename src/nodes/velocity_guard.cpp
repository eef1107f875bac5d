// SPDX-License-Identifier: BSD-3-Clause
#include <ros/ros.h>

#include <chrono>
#include <iostream>
#include <thread>

#include "pomdp_crowd_nav/ros/node_arguments.h"
#include "pomdp_crowd_nav/ros/output_relay.h"
#include "pomdp_crowd_nav/ros/process_memory.h"
#include "pomdp_crowd_nav/ros/ros_param_reader.h"
#include "pomdp_crowd_nav/ros/shutdown_request.h"
#include "pomdp_crowd_nav/ros/velocity_guard_server.h"

int main(int argc, char** argv) {
  ros::init(argc, argv, "velocity_guard", ros::init_options::NoSigintHandler);
  const auto status = pomdp_crowd_nav::answerArguments(
      "velocity_guard", "Limits velocity commands, and brakes for people and for silence.", argc,
      argv);
  if (status) return *status;
  pomdp_crowd_nav::relayOutput();  // no log holds up commands
  pomdp_crowd_nav::returnLargeBlocks();
  try {
    ros::NodeHandle node;
    ros::NodeHandle private_node("~");
    pomdp_crowd_nav::RosParamReader reader(private_node);
    pomdp_crowd_nav::VelocityGuardServer server(node, private_node,
                                                pomdp_crowd_nav::loadGuardNodeParams(reader));
    pomdp_crowd_nav::catchShutdownRequests();  // the base is stopped before the node goes
    ros::AsyncSpinner spinner(1);
    spinner.start();
    while (ros::ok() && !pomdp_crowd_nav::isShutdownRequested()) {
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    server.stopBase();
    spinner.stop();
  } catch (const std::exception& error) {
    std::cerr << "velocity_guard: " << error.what() << std::endl;
    return 2;
  }
  ros::shutdown();
  return 0;
}
