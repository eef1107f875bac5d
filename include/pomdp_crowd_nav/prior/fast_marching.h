// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "pomdp_crowd_nav/prior/trial_queue.h"

namespace pomdp_crowd_nav {

// The marching itself: accept() the cells where the front starts, run(), read the result.
//
// The cells lie in one flat array, all of a cell side by side for the cache, with a frame two cells
// wide around them, which is never entered, so that no neighbour needs a test for the border. The
// queue of trial cells keeps outdated entries and drops them when they come up.
class FastMarching {
 public:
  // `speed` [m/s] row by row, positive; `resolution` [m] per cell.
  FastMarching(const std::vector<float>& speed, int columns, int rows, double resolution);

  // Fixes the arrival time [s] and path length [m] of a cell before the march.
  void accept(int column, int row, double time, double path_length);

  void run();

  // Row by row, without the frame.
  std::vector<float> times() const { return withoutFrame(&Cell::time); }
  std::vector<float> pathLengths() const { return withoutFrame(&Cell::path_length); }

 private:
  struct Cell {
    float crossing_time = 0.0F;  // [s], 0 in the frame
    float time = 0.0F;           // [s], infinite until accepted
    float trial_time = 0.0F;     // [s], best so far; 0 once accepted and in the frame
    float path_length = 0.0F;    // [m]
  };
  // Accepted values upwind along one axis: weight * (T - time)^2 is the squared difference.
  struct Upwind {
    double weight = 0.0;       // 0 without an accepted neighbour
    double time = 0.0;         // [s]
    double path_length = 0.0;  // [m]
    double nearest = 0.0;      // [s], of the neighbour itself
  };
  struct Arrival {
    double time = 0.0;  // [s], infinite without a causal solution
    Upwind x, y;        // where from
  };

  static constexpr int kFrame = 2;

  int cellAt(int column, int row) const { return (row + kFrame) * stride_ + column + kFrame; }
  void updateNeighbours(int cell);
  void update(int cell);
  Upwind upwind(int cell, int axis_step, bool second_order) const;
  Arrival arrival(int cell) const;
  static Arrival solve(const Upwind& x, const Upwind& y, double crossing_time);
  double pathLength(const Arrival& arrival, double crossing_time) const;
  std::vector<float> withoutFrame(float Cell::*value) const;

  int columns_, rows_, stride_;
  double resolution_;
  std::vector<Cell> cells_;
  TrialQueue queue_;
};

}  // namespace pomdp_crowd_nav
