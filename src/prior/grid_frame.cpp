// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/prior/grid_frame.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace pomdp_crowd_nav {
namespace {

constexpr double kRounding = 1e-6;  // [cells]

// The whole part of a value that is first brought into [0, most].
int clampedFloor(double value, int most) {
  return static_cast<int>(std::clamp(value, 0.0, static_cast<double>(most)));
}

// A length that is a whole number of cells but for rounding gets no extra cell.
double cellsToCover(double length, double resolution) {
  return std::max(2.0, std::ceil(length / resolution - kRounding));
}

}  // namespace

bool GridFrame::contains(const Point& point) const {
  const Point cells = (point - origin) / resolution;
  return cells.x() >= -kRounding && cells.x() <= columns + kRounding && cells.y() >= -kRounding &&
         cells.y() <= rows + kRounding;
}

int GridFrame::columnOf(const Point& point) const {
  return clampedFloor((point.x() - origin.x()) / resolution, columns - 1);
}

int GridFrame::rowOf(const Point& point) const {
  return clampedFloor((point.y() - origin.y()) / resolution, rows - 1);
}

BilinearWeights bilinearWeights(const GridFrame& grid, const Point& point) {
  const double x = (point.x() - grid.origin.x()) / grid.resolution - 0.5;
  const double y = (point.y() - grid.origin.y()) / grid.resolution - 0.5;
  const int column = clampedFloor(x, grid.columns - 2);
  const int row = clampedFloor(y, grid.rows - 2);
  return {grid.index(column, row), x - column, y - row};
}

double interpolate(const GridFrame& grid, const std::vector<float>& values,
                   const BilinearWeights& w) {
  const float* lower = &values[w.lower_left];
  const float* upper = lower + grid.columns;
  const double below = (1.0 - w.right) * lower[0] + w.right * lower[1];
  const double above = (1.0 - w.right) * upper[0] + w.right * upper[1];
  return (1.0 - w.up) * below + w.up * above;
}

GridFrame coveringGrid(const Bounds& bounds, double resolution) {
  if (!(resolution > 0.0)) {
    throw std::invalid_argument(
        fmt::format("grid resolution must be positive, got {}", resolution));
  }
  constexpr double kMostCells = 1e8;
  const Point size = bounds.max - bounds.min;
  const double columns = cellsToCover(size.x(), resolution);
  const double rows = cellsToCover(size.y(), resolution);
  if (columns * rows > kMostCells) {
    throw std::invalid_argument(fmt::format("grid resolution {} m gives {} cells, more than {}",
                                            resolution, columns * rows, kMostCells));
  }
  return {bounds.min, resolution, static_cast<int>(columns), static_cast<int>(rows)};
}

}  // namespace pomdp_crowd_nav
