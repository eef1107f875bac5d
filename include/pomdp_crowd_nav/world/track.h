// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "pomdp_crowd_nav/world/geometry.h"

namespace pomdp_crowd_nav {

// What a sensor reports of one person at one moment, in the planning frame.
struct Track {
  std::int64_t id = 0;
  Point position{0.0, 0.0};  // [m]
  Point velocity{0.0, 0.0};  // [m/s], zero when the sensor gives none
};

// One sweep: everybody seen at `stamp`.
struct TrackList {
  double stamp = 0.0;  // [s]
  std::vector<Track> tracks;
};

}  // namespace pomdp_crowd_nav
