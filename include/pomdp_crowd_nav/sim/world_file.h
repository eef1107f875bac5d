// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "pomdp_crowd_nav/world/static_map.h"
#include "pomdp_crowd_nav/world/vehicle.h"

namespace pomdp_crowd_nav {

// A simulation set-up: where the robot drives, from where to where, and among whom.
struct World {
  std::string name;  // file name without ending
  Bounds bounds;
  StaticMap::Obstacles obstacles;
  Pose start;
  Point goal{0.0, 0.0};                // [m]
  std::vector<Point> destinations;     // [m], where people walk to
  std::string tracks_file;             // CSV of recorded people; empty: people are generated
  double tracks_start_time = 0.0;      // [s], time in the recording at which the replay starts
  std::vector<std::int64_t> left_out;  // ids of recorded people whom the robot replaces

  StaticMap map() const { return StaticMap(bounds, obstacles); }
};

// Reads `config/worlds/*.yaml`. Throws std::runtime_error with one line that names file, key, value
// and what was expected: for a missing file, a misspelt or unknown key, a wrong type, a start or
// goal off the map or inside an obstacle.
World loadWorld(const std::string& path);

}  // namespace pomdp_crowd_nav
