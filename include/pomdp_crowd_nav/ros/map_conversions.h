// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nav_msgs/OccupancyGrid.h>

#include <memory>

#include "pomdp_crowd_nav/world/static_map.h"

namespace pomdp_crowd_nav {

// Unknown cells and cells from 65 on are blocked. Throws std::invalid_argument for a grid without
// cells, of another size than it says, or turned against its frame.
std::shared_ptr<const StaticMap> toStaticMap(const nav_msgs::OccupancyGrid& grid);

nav_msgs::OccupancyGrid toMessage(const StaticMap& map, double resolution,
                                  const std_msgs::Header& header);

// Whether a grid says what the map says, only coarser, as the grid made by toMessage does.
bool isDrawingOf(const StaticMap& map, const nav_msgs::OccupancyGrid& grid);

}  // namespace pomdp_crowd_nav
