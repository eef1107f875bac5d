// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/prior/clearance_grid.h"

#include "pomdp_crowd_nav/prior/in_halves.h"

namespace pomdp_crowd_nav {

ClearanceGrid::ClearanceGrid(const StaticMap& of_map, double resolution)
    : map(of_map), grid(coveringGrid(of_map.bounds(), resolution)), clearance(grid.cellCount()) {
  inHalves(grid.rows, [this](int first_row, int last_row) {
    for (int row = first_row; row < last_row; ++row) {
      for (int column = 0; column < grid.columns; ++column) {
        clearance[grid.index(column, row)] = map.clearance(grid.center(column, row));
      }
    }
  });
}

}  // namespace pomdp_crowd_nav
