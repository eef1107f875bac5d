// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nav_msgs/OccupancyGrid.h>
#include <visualization_msgs/MarkerArray.h>

#include "pomdp_crowd_nav/prior/navigation_field.h"
#include "pomdp_crowd_nav/prior/roadmap_prior.h"

namespace pomdp_crowd_nav {

// When the robot would arrive from everywhere if nobody were about: for RViz's colour scheme
// "costmap". From 1 at the goal to 98 where the way to it is longest; 99 closer to an obstacle than
// `margin` [m], 100 inside of one, -1 where no way leads to the goal. A table of more than
// kMaxArrivalCells is shown more coarsely.
constexpr long kMaxArrivalCells = 1000000;
nav_msgs::OccupancyGrid arrivalTimeGrid(const NavigationField& field, double margin,
                                        const std_msgs::Header& header);

// Milestones, edges, and the shortest ways over them to the goal. Edges beyond kMaxRoadmapEdges are
// left out evenly, but none of the shortest ways; as markers.h says of all arrays.
constexpr size_t kMaxRoadmapEdges = 8000;
visualization_msgs::MarkerArray roadmapMarkers(const RoadmapPrior& prior, double symbol_size,
                                               const std_msgs::Header& header);

}  // namespace pomdp_crowd_nav
