// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "pomdp_crowd_nav/prior/cell_raster.h"
#include "pomdp_crowd_nav/prior/clearance_grid.h"

namespace pomdp_crowd_nav {

// A lower bound on the length of every drive to the goal that keeps clear of obstacles.
//
// A drive is a polyline whose corners lie at most half a stride apart, each in a cell of clearance
// above C. That no such polyline is shorter than the table says is certified on the table itself;
// how well Fast Marching solves its equation only decides how tight the table is.
//
// 1. Corners outside the rectangle of the cells' centres are moved to its border, which makes no
//    polyline longer. A corner is within h / sqrt(2) of its cell's centre, hence at least
//    X = C - h / sqrt(2) - e away from every obstacle's points, and what lies between two corners
//    at least sqrt(X^2 - (stride / 4)^2). So the centres of the four cells around any place of the
//    polyline have a clearance above openClearance() = that - sqrt(2) h - e: they are open. e is
//    the error with which clearance is known: 0 but for occupancy grids, see StaticMap. Cells off
//    an occupancy grid count as open, for clearance is but a lower limit there.
// 2. Arrival times T at the cells' centres are made continuous: each square between four of them
//    is cut along the diagonal that gives the flatter pair of triangles. At each level of T its
//    gradient is divided by the steepest of all open triangles that reach this level, and the
//    result by slope(), the steepest gradient that is left. Along a polyline it now changes by no
//    more than the length, for it passes open triangles only.
// 3. Of all this the most is taken off that the table may say within the goal's tolerance.
class ShortestWay {
 public:
  struct Params {
    double clearance = 3.0;       // [m], D_obs + L: C
    double stride = 2.0;          // [m], twice the longest way between two places that keep C
    double goal_tolerance = 1.0;  // [m], D_g: where a drive is over
  };

  // Throws std::invalid_argument when a parameter is negative.
  ShortestWay(const ClearanceGrid& map, const Point& goal, const Params& params);

  // [m] to within the goal's tolerance. Nothing is said, which is a length of 0 or less, in cells
  // of clearance up to C, where no way leads to the goal, and where strides leap over obstacles.
  float lengthFrom(float x, float y) const;

  // Certificate: the steepest open triangle of the table [m per m].
  double slope() const { return slope_; }

  double openClearance() const { return open_clearance_; }  // [m], infinite where strides leap

 private:
  // No place within `radius` [m] of the goal has more in the table, scaled.
  double mostNearGoal(const GridFrame& grid, const Point& goal, double radius) const;

  CellRaster raster_;
  double open_clearance_;
  double slope_ = 1.0;
  float scale_ = 0.0F;          // of the table
  float offset_ = 0.0F;         // [m], what the table says within the goal's tolerance
  std::vector<float> lengths_;  // [m], at the centres of the cells; 0 where nothing is known
  std::vector<char> is_clear_;  // whether corners of a drive may lie in the cell
};

}  // namespace pomdp_crowd_nav
