// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <visualization_msgs/MarkerArray.h>

#include <string>
#include <vector>

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

// People as they really are.
visualization_msgs::MarkerArray crowdMarkers(const std::vector<Walker>& walkers, double symbol_size,
                                             const std_msgs::Header& header);

// What a decision has looked at and chosen.
struct TreeScene {
  TreeView view;
  std::vector<Point> chosen;  // [m], places at the steps of the planned branch, from the start
};

// The tree from green (the best values in it) to red, deeper edges fainter, roll-outs dashed, and
// the chosen branch bold.
visualization_msgs::MarkerArray treeMarkers(const TreeScene& scene, double symbol_size,
                                            const std_msgs::Header& header);

// Colour of a destination, the same in all pictures.
std_msgs::ColorRGBA destinationColor(size_t index, double alpha);

}  // namespace pomdp_crowd_nav
