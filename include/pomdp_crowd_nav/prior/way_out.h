// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "pomdp_crowd_nav/prior/grid_frame.h"
#include "pomdp_crowd_nav/prior/line_of_sight.h"

namespace pomdp_crowd_nav {

// The nearest place clear of obstacles, for whoever is inside the clearance: a table over a grid.
class WayOut {
 public:
  // `sight` must outlive the table.
  explicit WayOut(const LineOfSight& sight);

  // Centre of the nearest cell that keeps the clearance; nothing where there is none or it lies
  // behind a wall.
  std::optional<Point> nearestFree(const Point& position) const;

 private:
  bool isBehindWall(const Point& place, const Point& from) const;

  const LineOfSight& sight_;
  GridFrame grid_;
  std::vector<int> nearest_free_;  // per cell: index of a cell, -1 for none
};

}  // namespace pomdp_crowd_nav
