// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "pomdp_crowd_nav/belief/belief_tracker.h"
#include "pomdp_crowd_nav/control/command_generator.h"
#include "pomdp_crowd_nav/control/emergency_override.h"
#include "pomdp_crowd_nav/control/progress_watch.h"
#include "pomdp_crowd_nav/control/velocity_guard.h"
#include "pomdp_crowd_nav/params/param_reader.h"
#include "pomdp_crowd_nav/planner/planner.h"
#include "pomdp_crowd_nav/sim/simulator.h"

namespace pomdp_crowd_nav {

// Everything that a profile (config/profiles/*.yaml) sets: one vehicle and how it is to drive.
struct NavigationParams {
  std::string planner = "2d_fmm";
  PlannerParams planning;
  double search_time = 0.35;  // [s] of wall clock for one decision
  BeliefTracker::Params belief;
  EmergencyOverride::Params emergency;
  CommandGenerator::Params command;
  VelocityGuard::Params guard;
  ProgressWatch::Params progress;
  double controller_frequency = 20.0;  // [Hz]
  double yaw_goal_tolerance = 3.15;    // [rad], above pi: any heading at the goal will do
  double trans_stopped_vel = 0.03;     // [m/s], a slower base counts as at rest
  double rot_stopped_vel = 0.05;       // [rad/s], the same of its yaw rate
  double odom_timeout = 0.5;           // [s], an older input stops the robot
  double people_timeout = 1.0;         // [s]
  double transform_tolerance = 0.2;    // [s]
  int tree_depth = 6;                  // of the search tree in pictures, in steps
};

// Reads the keys of a profile over the present values, and checks that they are words it knows.
void readNavigationParams(ParamReader& reader, NavigationParams& params);

// Throws std::invalid_argument, one line naming the key, for a value out of range and for values
// that do not go together.
void validate(const NavigationParams& params);

// Both, over the defaults, with planner_frequency 2 Hz. Keys are ROS names where ROS has a name
// (README, parameters).
// Throws std::runtime_error (type) or std::invalid_argument (range), one line naming the key.
NavigationParams loadNavigationParams(ParamReader& reader);

// Reads "sensor/..." and "command_timeout"; the vehicle is the profile's.
Simulator::Params loadSimulatorParams(ParamReader& reader, const VehicleParams& vehicle);

}  // namespace pomdp_crowd_nav
