// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "pomdp_crowd_nav/world/static_map.h"

namespace pomdp_crowd_nav {

// Where the square cells of a grid lie; they are stored row by row from the lower left corner.
struct GridFrame {
  Point origin{0.0, 0.0};   // [m], corner of cell (0, 0)
  double resolution = 0.1;  // [m] per cell
  int columns = 0;          // cells along x
  int rows = 0;             // cells along y

  size_t cellCount() const { return static_cast<size_t>(columns) * static_cast<size_t>(rows); }
  size_t index(int column, int row) const { return static_cast<size_t>(row) * columns + column; }
  Point center(int column, int row) const {
    return origin + resolution * Point(column + 0.5, row + 0.5);
  }

  // True on the grid and on its border, give or take rounding.
  bool contains(const Point& point) const;

  // Cell that holds a point of the grid.
  int columnOf(const Point& point) const;
  int rowOf(const Point& point) const;
};

// A point between four cell centres. Between the outermost centres and the border of the grid
// the shares leave [0, 1], so that interpolation extrapolates.
struct BilinearWeights {
  size_t lower_left = 0;  // index of the cell
  double right = 0.0;     // share of the right cells
  double up = 0.0;        // share of the upper cells
};

// The grid needs at least 2 x 2 cells.
BilinearWeights bilinearWeights(const GridFrame& grid, const Point& point);

double interpolate(const GridFrame& grid, const std::vector<float>& values,
                   const BilinearWeights& weights);
inline double interpolate(const GridFrame& grid, const std::vector<float>& values,
                          const Point& point) {
  return interpolate(grid, values, bilinearWeights(grid, point));
}

// Grid from the lower left corner of the bounds that covers them, of at least 2 x 2 cells. Throws
// std::invalid_argument when the resolution is not positive or asks for more than 1e8 cells.
GridFrame coveringGrid(const Bounds& bounds, double resolution);

}  // namespace pomdp_crowd_nav
