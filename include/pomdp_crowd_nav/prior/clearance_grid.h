// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "pomdp_crowd_nav/prior/grid_frame.h"
#include "pomdp_crowd_nav/world/static_map.h"

namespace pomdp_crowd_nav {

// A map and its clearance at the centres of the cells of a grid that covers it: what priors and
// tables take from a map, whatever the goal. Made once per map, shared by all goals. Immutable.
struct ClearanceGrid {
  // `resolution` [m] per cell. Throws std::invalid_argument as coveringGrid does.
  ClearanceGrid(const StaticMap& of_map, double resolution);

  StaticMap map;
  GridFrame grid;
  std::vector<double> clearance;  // [m], row by row; infinite on a map without obstacles
};

}  // namespace pomdp_crowd_nav
