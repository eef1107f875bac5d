// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pomdp_crowd_nav/prior/grid_frame.h"

namespace pomdp_crowd_nav {

// How a place finds its cell, in the search's own precision. Cells are numbered row by row; places
// off the grid have the nearest cell of its border.
struct CellRaster {
  CellRaster() = default;
  explicit CellRaster(const GridFrame& grid)
      : min_x(static_cast<float>(grid.origin.x())),
        min_y(static_cast<float>(grid.origin.y())),
        cells_per_meter(static_cast<float>(1.0 / grid.resolution)),
        last_column(static_cast<float>(grid.columns - 1)),
        last_row(static_cast<float>(grid.rows - 1)),
        columns(grid.columns) {}

  int cellOf(float x, float y) const {
    return clamped((y - min_y) * cells_per_meter, last_row) * columns +
           clamped((x - min_x) * cells_per_meter, last_column);
  }

  float min_x = 0.0F, min_y = 0.0F;  // [m]
  float cells_per_meter = 1.0F;
  float zero = 0.0F;  // as data, for which compilers make better code than for a constant
  float last_column = 0.0F, last_row = 0.0F;
  int columns = 1;

 private:
  static int clamped(float cell, float last) {
    const float inside = cell > 0.0F ? cell : 0.0F;
    return static_cast<int>(inside < last ? inside : last);
  }
};

}  // namespace pomdp_crowd_nav
