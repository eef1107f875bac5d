// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/prior/navigation_field.h"

#include <algorithm>
#include <cmath>

#include "pomdp_crowd_nav/prior/grid_frame.h"
#include "pomdp_crowd_nav/prior/in_halves.h"

namespace pomdp_crowd_nav {
namespace {

// Stands for infinity: stays finite in whatever the search computes from it.
constexpr double kFar = 1e6;  // [m]

float finite(double distance) { return static_cast<float>(std::min(kFar, distance)); }

}  // namespace

PackedDirection packDirection(double x, double y) {
  const auto low = static_cast<std::uint32_t>(std::lround(x / kPackedUnit)) & 0xFFFFU;
  const auto high = static_cast<std::uint32_t>(std::lround(y / kPackedUnit)) << 16;
  return static_cast<PackedDirection>(high | low);
}

NavigationField::NavigationField(const RolloutPrior& prior, const ClearanceGrid& clearances)
    : bounds_(clearances.map.bounds()),
      goal_(prior.goal()),
      has_obstacles_(clearances.map.hasObstacles()),
      is_straight_line_(prior.isStraightLine()),
      raster_(clearances.grid) {
  const GridFrame& grid = clearances.grid;
  const size_t count = grid.cellCount();
  directions_.resize(count);
  clearances_.resize(count);
  distances_.resize(count);
  inHalves(grid.rows, [&](int first_row, int last_row) {
    for (int row = first_row; row < last_row; ++row) {
      for (int column = 0; column < grid.columns; ++column) {
        const size_t cell = grid.index(column, row);
        const Course course = prior.courseAt({grid.center(column, row), 0.0});
        directions_[cell] = packDirection(course.direction.x(), course.direction.y());
        clearances_[cell] = finite(clearances.clearance[cell]);
        distances_[cell] = finite(course.distance);
      }
    }
  });
}

}  // namespace pomdp_crowd_nav
