// SPDX-License-Identifier: BSD-3-Clause
#include <ros/ros.h>

#include <iostream>

#include "pomdp_crowd_nav/ros/node_arguments.h"
#include "pomdp_crowd_nav/ros/ros_param_reader.h"
#include "pomdp_crowd_nav/ros/simulation_server.h"

int main(int argc, char** argv) {
  ros::init(argc, argv, "sim_node");
  const auto status =
      pomdp_crowd_nav::answerArguments("sim_node", "Simulates a robot among people.", argc, argv);
  if (status) return *status;
  try {
    ros::NodeHandle node;
    ros::NodeHandle private_node("~");
    pomdp_crowd_nav::RosParamReader reader(private_node);
    pomdp_crowd_nav::SimulationServer server(node, private_node,
                                             pomdp_crowd_nav::loadSimNodeParams(reader));
    ros::spin();
  } catch (const std::exception& error) {
    std::cerr << "sim_node: " << error.what() << std::endl;
    return 2;
  }
  return 0;
}
