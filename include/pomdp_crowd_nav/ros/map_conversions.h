// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nav_msgs/OccupancyGrid.h>

#include <cstdint>
#include <memory>

#include "pomdp_crowd_nav/world/static_map.h"

namespace pomdp_crowd_nav {

enum class UnknownSpace { kObstacle, kFree };

// How the cells of an occupancy grid are read.
struct MapPolicy {
  UnknownSpace unknown = UnknownSpace::kObstacle;  // cells of -1 and all that are not in 0..100
  int occupied_threshold = 65;                     // of 100; cells from it on are obstacles

  bool isBlocked(std::int8_t cell) const {
    const bool is_known = cell >= 0 && cell <= 100;
    return is_known ? cell >= occupied_threshold : unknown == UnknownSpace::kObstacle;
  }
};

// Throws std::invalid_argument for a grid without cells, of another size than it says, or whose
// resolution or origin is not finite. A grid that is turned against its frame is sampled anew, in
// cells of the same size: no blocked cell gets lost, and what the grid does not cover of the
// rectangle around it is blocked.
std::shared_ptr<const StaticMap> toStaticMap(const nav_msgs::OccupancyGrid& grid,
                                             const MapPolicy& policy = MapPolicy());

nav_msgs::OccupancyGrid toMessage(const StaticMap& map, double resolution,
                                  const std_msgs::Header& header);

// Whether a grid says what the map says, only coarser, as the grid made by toMessage does.
bool isDrawingOf(const StaticMap& map, const nav_msgs::OccupancyGrid& grid,
                 const MapPolicy& policy = MapPolicy());

}  // namespace pomdp_crowd_nav
