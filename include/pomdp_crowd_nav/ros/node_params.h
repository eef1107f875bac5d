// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "pomdp_crowd_nav/params/load_params.h"
#include "pomdp_crowd_nav/ros/map_conversions.h"
#include "pomdp_crowd_nav/sim/world_file.h"

namespace pomdp_crowd_nav {

// Names of the frames, REP-105.
struct FrameNames {
  std::string global = "map";
  std::string odom = "odom";
  std::string base = "base_link";
};

struct PlannerNodeParams {
  NavigationParams navigation;
  FrameNames frames;
  std::string world_file;           // gives obstacles and destinations; empty: the map topic does
  std::vector<Point> destinations;  // [m], of people, in the global frame
  double map_timeout = 0.0;         // [s], 0: a map does not age
  MapPolicy map;                    // how the map topic is read
};

struct SimNodeParams {
  NavigationParams navigation;  // the vehicle and the decision step of the profile
  Simulator::Params simulator;
  FrameNames frames;
  std::string world_file;
  std::string tracks_file;      // replaces the world's; empty: as the world says
  double map_resolution = 0.1;  // [m] per cell of the published map
};

// Both read a whole namespace. They throw with one line that names the key: for a value of the
// wrong type or out of range, for a key that is not known, for an unknown planner, and where
// neither a world file nor the parameter gives destinations.
PlannerNodeParams loadPlannerNodeParams(ParamReader& reader);
SimNodeParams loadSimNodeParams(ParamReader& reader);

// The world of a simulator node, its tracks file replaced where the parameters say so.
World loadSimWorld(const SimNodeParams& params);

}  // namespace pomdp_crowd_nav
