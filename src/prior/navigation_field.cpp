// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/prior/navigation_field.h"

#include <algorithm>

#include "pomdp_crowd_nav/prior/grid_frame.h"

namespace pomdp_crowd_nav {
namespace {

// Stands for infinity: stays finite in whatever the search computes from it.
constexpr double kFar = 1e6;  // [m]

NavigationCell sample(const RolloutPrior& prior, const StaticMap& map, const Point& point) {
  NavigationCell cell;
  if (const auto direction = prior.directionAt({point, 0.0})) {
    const Point way = unitVector(*direction);
    cell.direction_x = static_cast<float>(way.x());
    cell.direction_y = static_cast<float>(way.y());
  }
  cell.clearance = static_cast<float>(std::min(kFar, map.clearance(point)));
  cell.distance_to_goal = static_cast<float>(std::min(kFar, prior.distanceToGoal(point)));
  return cell;
}

}  // namespace

NavigationField::NavigationField(const RolloutPrior& prior, const StaticMap& map, double resolution)
    : bounds_(map.bounds()), goal_(prior.goal()), has_obstacles_(map.hasObstacles()) {
  const GridFrame grid = coveringGrid(bounds_, resolution);
  min_x_ = static_cast<float>(grid.origin.x());
  min_y_ = static_cast<float>(grid.origin.y());
  cells_per_meter_ = static_cast<float>(1.0 / resolution);
  columns_ = grid.columns;
  rows_ = grid.rows;
  cells_.reserve(grid.cellCount());
  for (int row = 0; row < rows_; ++row) {
    for (int column = 0; column < columns_; ++column) {
      cells_.push_back(sample(prior, map, grid.center(column, row)));
    }
  }
}

}  // namespace pomdp_crowd_nav
