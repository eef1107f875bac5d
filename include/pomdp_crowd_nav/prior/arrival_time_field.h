// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "pomdp_crowd_nav/prior/grid_frame.h"

namespace pomdp_crowd_nav {

// How fast a front passes each cell of a grid. Made once per map, used for every source.
struct SpeedMap {
  GridFrame grid;
  std::vector<float> speed;  // [m/s], positive
};

// When a front that leaves the source at time 0 reaches each cell: the solution T of the eikonal
// equation 1 = F |grad T| (paper, section on Fast Marching), at the centres of the cells.
//
// Fast Marching (Sethian 1996) with second-order upwind differences (Sethian 1999) where two
// accepted cells lie upwind and the result is causal, first-order ones elsewhere. Beside the time
// it carries the length of the fastest path, which is constant speed's T over free cells and,
// unlike T, is not inflated by slow ones.
//
// T is not smooth at the source, which would cost the scheme its order. So cells near it, in
// sight of it over cells of its own speed, start from their exact distance. Errors fall with the
// square of the cell on an empty field and linearly behind obstacles, whose outline is a
// staircase of cells.
class ArrivalTimeField {
 public:
  struct Params {
    double exact_radius = 3.0;  // [m] around the source
  };

  // Throws std::invalid_argument when the grid has fewer than 2 x 2 cells or does not match its
  // speeds, a speed is not positive, or the source is off the grid (its border is on it).
  ArrivalTimeField(const SpeedMap& map, const Point& source, const Params& params);
  ArrivalTimeField(const SpeedMap& map, const Point& source)
      : ArrivalTimeField(map, source, Params()) {}

  const GridFrame& grid() const { return grid_; }
  const Point& source() const { return source_; }

  // Per cell: [s] and [m].
  const std::vector<float>& times() const { return times_; }
  const std::vector<float>& pathLengths() const { return path_lengths_; }

  // Interpolated between cell centres; the point must be on the grid.
  double timeAt(const Point& point) const { return interpolate(grid_, times_, point); }
  double pathLengthAt(const Point& point) const { return interpolate(grid_, path_lengths_, point); }

 private:
  GridFrame grid_;
  Point source_;
  std::vector<float> times_, path_lengths_;
};

}  // namespace pomdp_crowd_nav
