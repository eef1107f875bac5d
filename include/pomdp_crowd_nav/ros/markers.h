// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <visualization_msgs/MarkerArray.h>

#include <string>
#include <vector>

#include "pomdp_crowd_nav/belief/belief_tracker.h"
#include "pomdp_crowd_nav/planner/planner.h"
#include "pomdp_crowd_nav/sim/crowd.h"
#include "pomdp_crowd_nav/sim/world_file.h"

namespace pomdp_crowd_nav {

// Pictures for RViz. Each array replaces the one before: it begins with DELETEALL and holds a few
// list markers of less than kMaxPoints points; what does not fit is left out.
constexpr size_t kMaxPoints = 16384;

// Size [m] of a person's symbol that is well seen when all of the field is: a little larger than
// life on a large field. Other symbols and lines are drawn in proportion.
double symbolSize(const Bounds& field);

// Field, obstacles, destinations, start and goal of a world; `tolerance` [m] around the goal.
visualization_msgs::MarkerArray worldMarkers(const World& world, double tolerance,
                                             const std_msgs::Header& header);

// People as they really are, where the robot has driven, and its disc.
struct CrowdScene {
  const std::vector<Walker>& walkers;
  const std::vector<Point>& trail;  // [m]
  Pose robot;
  double robot_radius = 0.0;  // [m]
  double symbol_size = 0.5;   // [m]
};
visualization_msgs::MarkerArray crowdMarkers(const CrowdScene& scene,
                                             const std_msgs::Header& header);

// Every person in the colour of the most likely destination, the more opaque the surer, with a
// line toward it; those whose futures are searched have a ring.
struct BeliefScene {
  const CrowdBelief& crowd;
  const std::vector<Point>& destinations;     // [m]
  const std::vector<std::int64_t>& attended;  // ids
  double symbol_size = 0.5;                   // [m]
};
visualization_msgs::MarkerArray beliefMarkers(const BeliefScene& scene,
                                              const std_msgs::Header& header);

// The tree from green (the best values in it) to red, deeper edges fainter, and roll-outs dashed.
visualization_msgs::MarkerArray treeMarkers(const TreeView& view, double symbol_size,
                                            const std_msgs::Header& header);

// Colour of a destination, the same in all pictures.
std_msgs::ColorRGBA destinationColor(size_t index, double alpha);

}  // namespace pomdp_crowd_nav
