// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/prior/clearance_grid.h"

namespace pomdp_crowd_nav {

ClearanceGrid::ClearanceGrid(const StaticMap& of_map, double resolution)
    : map(of_map), grid(coveringGrid(of_map.bounds(), resolution)) {
  clearance.reserve(grid.cellCount());
  for (int row = 0; row < grid.rows; ++row) {
    for (int column = 0; column < grid.columns; ++column) {
      clearance.push_back(map.clearance(grid.center(column, row)));
    }
  }
}

}  // namespace pomdp_crowd_nav
