// SPDX-License-Identifier: BSD-3-Clause
#include <nodelet/nodelet.h>
#include <ros/ros.h>

#include <memory>
#include <pluginlib/class_list_macros.hpp>

#include "pomdp_crowd_nav/ros/ros_param_reader.h"
#include "pomdp_crowd_nav/ros/simulation_server.h"

namespace pomdp_crowd_nav {

// sim_node in the process of a nodelet manager; all its callbacks run in one thread, as there.
class SimNodelet : public nodelet::Nodelet {
 private:
  void onInit() override {
    try {
      const ros::NodeHandle private_node = getPrivateNodeHandle();
      RosParamReader reader(private_node);
      server_ = std::make_unique<SimulationServer>(getNodeHandle(), private_node,
                                                   loadSimNodeParams(reader));
    } catch (const std::exception& error) {
      NODELET_FATAL("%s: %s", getName().c_str(), error.what());
      throw;  // the manager reports that it was not loaded
    }
  }

  std::unique_ptr<SimulationServer> server_;
};

}  // namespace pomdp_crowd_nav

PLUGINLIB_EXPORT_CLASS(pomdp_crowd_nav::SimNodelet, nodelet::Nodelet)
