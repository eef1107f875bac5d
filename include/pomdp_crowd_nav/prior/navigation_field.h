// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "pomdp_crowd_nav/prior/rollout_prior.h"
#include "pomdp_crowd_nav/world/static_map.h"

namespace pomdp_crowd_nav {

// What the search needs to know of a place, sampled at the cell's centre. 16 bytes: one access.
struct NavigationCell {
  float direction_x = 0.0F;  // unit vector of travel toward the goal, (0, 0) if unreachable
  float direction_y = 0.0F;
  float clearance = 0.0F;         // [m] to the nearest obstacle, 1e6 on a map without
  float distance_to_goal = 0.0F;  // [m] along the prior's path, 1e6 if unreachable
};

// A prior and the clearance of the map as one table, so that the search makes no virtual call and
// pays the same for every prior. Nearest-cell lookup; places off the map read the border cell.
class NavigationField {
 public:
  // `resolution` [m] per cell; throws std::invalid_argument unless it is positive.
  NavigationField(const RolloutPrior& prior, const StaticMap& map, double resolution);

  const NavigationCell& at(float x, float y) const {
    return cells_[static_cast<size_t>(row(y)) * columns_ + column(x)];
  }

  const Point& goal() const { return goal_; }
  const Bounds& bounds() const { return bounds_; }
  bool hasObstacles() const { return has_obstacles_; }
  const NavigationCell* cells() const { return cells_.data(); }
  int columns() const { return columns_; }
  int rows() const { return rows_; }
  float cellsPerMeter() const { return cells_per_meter_; }

 private:
  int column(float x) const { return clampedIndex((x - min_x_) * cells_per_meter_, columns_); }
  int row(float y) const { return clampedIndex((y - min_y_) * cells_per_meter_, rows_); }
  static int clampedIndex(float cell, int count) {
    if (!(cell > 0.0F)) return 0;
    return cell < static_cast<float>(count) ? static_cast<int>(cell) : count - 1;
  }

  Bounds bounds_;
  Point goal_;
  bool has_obstacles_;
  float min_x_, min_y_, cells_per_meter_;
  int columns_, rows_;
  std::vector<NavigationCell> cells_;
};

}  // namespace pomdp_crowd_nav
