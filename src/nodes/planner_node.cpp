// SPDX-License-Identifier: BSD-3-Clause
#include <ros/ros.h>

#include <chrono>
#include <iostream>
#include <thread>

#include "pomdp_crowd_nav/ros/navigation_server.h"
#include "pomdp_crowd_nav/ros/node_arguments.h"
#include "pomdp_crowd_nav/ros/output_relay.h"
#include "pomdp_crowd_nav/ros/process_memory.h"
#include "pomdp_crowd_nav/ros/ros_param_reader.h"
#include "pomdp_crowd_nav/ros/shutdown_request.h"

int main(int argc, char** argv) {
  ros::init(argc, argv, "planner_node", ros::init_options::NoSigintHandler);
  const auto status = pomdp_crowd_nav::answerArguments(
      "planner_node", "Drives a robot through a crowd to the goals that it is sent.", argc, argv);
  if (status) return *status;
  pomdp_crowd_nav::relayOutput();  // no log holds up commands
  pomdp_crowd_nav::returnLargeBlocks();
  try {
    ros::NodeHandle node;
    ros::NodeHandle private_node("~");
    pomdp_crowd_nav::RosParamReader reader(private_node);
    pomdp_crowd_nav::NavigationServer server(node, private_node,
                                             pomdp_crowd_nav::loadPlannerNodeParams(reader));
    pomdp_crowd_nav::catchShutdownRequests();  // the base is stopped before the node goes
    ros::AsyncSpinner spinner(4);
    spinner.start();
    while (ros::ok() && !pomdp_crowd_nav::isShutdownRequested()) {
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    server.stopBase();
    spinner.stop();
  } catch (const std::exception& error) {
    std::cerr << "planner_node: " << error.what() << std::endl;
    return 2;
  }
  ros::shutdown();
  return 0;
}
