// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <geometry_msgs/PoseWithCovarianceStamped.h>
#include <ros/ros.h>
#include <tf2_ros/transform_broadcaster.h>

#include <memory>

#include "pomdp_crowd_nav/ros/conversions.h"
#include "pomdp_crowd_nav/ros/node_params.h"
#include "pomdp_crowd_nav/ros/trip_observer.h"

namespace pomdp_crowd_nav {

// The simulator node: a Simulator that runs in real time and looks like a robot from outside.
//
// All callbacks run in one thread. With use_sim_time it publishes the clock, and never asks for
// it: its own time is the wall's at the start plus what has been simulated.
class SimulationServer {
 public:
  // Throws with one line for a world or tracks file that cannot be read and for parameters out of
  // range.
  SimulationServer(ros::NodeHandle node, ros::NodeHandle private_node, const SimNodeParams& params);

 private:
  struct Publishers {
    ros::Publisher clock, odom, map, persons, crowd_markers, world_markers, metrics;
  };

  void advertise(ros::NodeHandle& node, ros::NodeHandle& private_node);
  void subscribe(ros::NodeHandle& node, ros::NodeHandle& private_node);
  void start(const SimNodeParams& params);

  void onTimer(const ros::SteadyTimerEvent& event);
  void step();
  void publishBase();
  void publishCrowd();
  void publishWorld();
  void publishMetrics();

  void onCommand(const geometry_msgs::Twist& twist);
  void onInitialPose(const geometry_msgs::PoseWithCovarianceStamped& pose);
  void onGoal(const geometry_msgs::PoseStamped& goal);
  void onPlannerStatus(const PlannerStatus& status) { planner_status_ = status; }
  bool onReset(ResetSimulation::Request& request, ResetSimulation::Response& response);
  bool onPause(PauseService::Request& request, PauseService::Response& response);

  ros::Time now() const;
  std_msgs::Header header(const std::string& frame) const;

  SimNodeParams params_;
  std::unique_ptr<Simulator> simulator_;
  std::unique_ptr<TripObserver> observer_;
  PlannerStatus planner_status_;
  Pose odom_origin_;                // of the odometry frame, in the global frame
  ros::Time start_time_;            // of the node, system clock
  double time_before_reset_ = 0.0;  // [s], simulated before the last reset
  bool use_sim_time_ = false;
  bool is_paused_ = false;
  double last_tick_ = 0.0;  // [s], steady clock
  long steps_ = 0;          // since the last reset

  Publishers publishers_;
  std::vector<ros::Subscriber> subscribers_;
  std::vector<ros::ServiceServer> services_;
  tf2_ros::TransformBroadcaster transforms_;
  ros::SteadyTimer timer_;
};

}  // namespace pomdp_crowd_nav
