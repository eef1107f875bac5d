// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "pomdp_crowd_nav/prior/arrival_time_field.h"

namespace pomdp_crowd_nav {

// Unit vectors, one per cell of a grid.
struct Directions {
  std::vector<float> x, y;
};

// Which way the fastest path to the source of the field leaves each cell: against the gradient of
// the arrival time, taken with the Sobel kernel. None points off the grid.
Directions descentDirections(const ArrivalTimeField& field, const SpeedMap& speed_map);

}  // namespace pomdp_crowd_nav
