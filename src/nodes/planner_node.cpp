// SPDX-License-Identifier: BSD-3-Clause
#include <ros/ros.h>
#include <ros/xmlrpc_manager.h>

#include <chrono>
#include <csignal>
#include <iostream>
#include <thread>

#include "pomdp_crowd_nav/ros/navigation_server.h"
#include "pomdp_crowd_nav/ros/node_arguments.h"
#include "pomdp_crowd_nav/ros/ros_param_reader.h"

namespace {

volatile std::sig_atomic_t is_interrupted = 0;

void interrupt(int) { is_interrupted = 1; }

// As roscpp answers `rosnode kill` and the master, but not before the base is stopped.
void onShutdown(XmlRpc::XmlRpcValue&, XmlRpc::XmlRpcValue& result) {
  is_interrupted = 1;
  result = ros::xmlrpc::responseInt(1, "", 0);
}

}  // namespace

int main(int argc, char** argv) {
  ros::init(argc, argv, "planner_node", ros::init_options::NoSigintHandler);
  const auto status = pomdp_crowd_nav::answerArguments(
      "planner_node", "Drives a robot through a crowd to the goals that it is sent.", argc, argv);
  if (status) return *status;
  try {
    ros::NodeHandle node;
    ros::NodeHandle private_node("~");
    pomdp_crowd_nav::RosParamReader reader(private_node);
    pomdp_crowd_nav::NavigationServer server(node, private_node,
                                             pomdp_crowd_nav::loadPlannerNodeParams(reader));
    std::signal(SIGINT, interrupt);  // the base is stopped before the node goes
    std::signal(SIGTERM, interrupt);
    ros::XMLRPCManager::instance()->unbind("shutdown");
    ros::XMLRPCManager::instance()->bind("shutdown", onShutdown);
    ros::AsyncSpinner spinner(4);
    spinner.start();
    while (ros::ok() && !is_interrupted) std::this_thread::sleep_for(std::chrono::milliseconds(20));
    server.stopBase();
    spinner.stop();
  } catch (const std::exception& error) {
    std::cerr << "planner_node: " << error.what() << std::endl;
    return 2;
  }
  ros::shutdown();
  return 0;
}
