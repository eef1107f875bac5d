// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/prior/way_out.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>

namespace pomdp_crowd_nav {
namespace {

constexpr double kFinestCell = 0.1;  // [m]
constexpr double kCellsPerClearance = 16.0;

// 0 where a cell is free.
cv::Mat_<uchar> blockedCells(const GridFrame& grid, const LineOfSight& sight) {
  cv::Mat_<uchar> blocked(grid.rows, grid.columns);
  for (int row = 0; row < grid.rows; ++row) {
    for (int column = 0; column < grid.columns; ++column) {
      const bool is_free = sight.isFree(grid.center(column, row));
      blocked(row, column) = is_free ? 0 : 255;
    }
  }
  return blocked;
}

}  // namespace

WayOut::WayOut(const LineOfSight& sight)
    : sight_(sight),
      grid_(coveringGrid(sight.map().bounds(),
                         std::max(kFinestCell, sight.clearance() / kCellsPerClearance))),
      nearest_free_(grid_.cellCount(), -1) {
  const cv::Mat_<uchar> blocked = blockedCells(grid_, sight);
  cv::Mat distance;
  cv::Mat_<int> labels;
  cv::distanceTransform(blocked, distance, labels, cv::DIST_L2, cv::DIST_MASK_5,
                        cv::DIST_LABEL_PIXEL);
  std::vector<int> cell_of_label(grid_.cellCount() + 1, -1);
  for (size_t cell = 0; cell < grid_.cellCount(); ++cell) {
    if (blocked.data[cell] == 0)
      cell_of_label[labels(static_cast<int>(cell))] = static_cast<int>(cell);
  }
  for (size_t cell = 0; cell < grid_.cellCount(); ++cell) {
    nearest_free_[cell] = cell_of_label[labels(static_cast<int>(cell))];
  }
}

// A wall between them would be at least as far from each as their clearance. From inside an
// obstacle every way out will do.
bool WayOut::isBehindWall(const Point& place, const Point& from) const {
  const double clearance = sight_.map().clearance(from);
  if (clearance <= 0.0 || (place - from).norm() < sight_.clearance() + clearance) return false;
  return !sight_.isClear(from, place, 0.0);
}

std::optional<Point> WayOut::nearestFree(const Point& position) const {
  const int cell = nearest_free_[grid_.index(grid_.columnOf(position), grid_.rowOf(position))];
  if (cell < 0) return std::nullopt;
  const Point place = grid_.center(cell % grid_.columns, cell / grid_.columns);
  if (isBehindWall(place, position)) return std::nullopt;
  return place;
}

}  // namespace pomdp_crowd_nav
