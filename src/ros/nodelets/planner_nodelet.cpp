// SPDX-License-Identifier: BSD-3-Clause
#include <nodelet/nodelet.h>
#include <ros/ros.h>

#include <memory>
#include <pluginlib/class_list_macros.hpp>

#include "pomdp_crowd_nav/ros/navigation_server.h"
#include "pomdp_crowd_nav/ros/ros_param_reader.h"

namespace pomdp_crowd_nav {

// planner_node in the process of a nodelet manager. When it is unloaded the base is stopped first.
class PlannerNodelet : public nodelet::Nodelet {
 public:
  ~PlannerNodelet() override {
    if (server_ && ros::ok()) server_->stopBase();
  }

 private:
  void onInit() override {
    try {
      const ros::NodeHandle private_node = getMTPrivateNodeHandle();
      RosParamReader reader(private_node);
      server_ = std::make_unique<NavigationServer>(getMTNodeHandle(), private_node,
                                                   loadPlannerNodeParams(reader));
    } catch (const std::exception& error) {
      NODELET_FATAL("%s: %s", getName().c_str(), error.what());
      throw;  // the manager reports that it was not loaded
    }
  }

  std::unique_ptr<NavigationServer> server_;
};

}  // namespace pomdp_crowd_nav

PLUGINLIB_EXPORT_CLASS(pomdp_crowd_nav::PlannerNodelet, nodelet::Nodelet)
