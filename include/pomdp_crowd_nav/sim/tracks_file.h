// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "pomdp_crowd_nav/world/geometry.h"

namespace pomdp_crowd_nav {

// Where one recorded person was at one moment.
struct TrackSample {
  double time = 0.0;  // [s]
  std::int64_t id = 0;
  Point position{0.0, 0.0};  // [m]
};

// Reads a CSV file with the header `time_s,ped_id,x_m,y_m` and rows in order of time. Throws
// std::runtime_error with one line that names file, line, column and value: for a file that cannot
// be read, a missing header, a value that is no finite number, rows out of order, a person twice
// at one time, and a file without rows.
std::vector<TrackSample> readTracksFile(const std::string& path);

}  // namespace pomdp_crowd_nav
