// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <vector>

namespace pomdp_crowd_nav {

// A field of rocks, left by its east edge. The default is RockSample(7,8) of Smith and Simmons
// 2004.
struct RockSampleMap {
  struct Cell {
    int x = 0;
    int y = 0;
  };
  static constexpr int kMostRocks = 8;

  int size = 7;  // [cells] along a side
  Cell start{0, 3};
  std::vector<Cell> rocks{{2, 0}, {0, 1}, {3, 1}, {6, 3}, {2, 4}, {3, 4}, {5, 5}, {1, 6}};
  double half_efficiency_distance = 20.0;  // [cells]
  double discount = 0.95;

  int rockCount() const { return static_cast<int>(rocks.size()); }
  int cellCount() const { return size * size; }
  int index(const Cell& cell) const { return cell.y * size + cell.x; }

  // -1 where there is none.
  int rockAt(int cell) const {
    for (int r = 0; r < rockCount(); ++r) {
      if (index(rocks[r]) == cell) return r;
    }
    return -1;
  }

  // The robot's cell after a move; the same one at the other edges, -1 once it has left by the
  // east.
  int moved(int cell, int action) const {
    constexpr int kStepX[] = {0, 1, 0, -1};
    constexpr int kStepY[] = {1, 0, -1, 0};
    const Cell to{cell % size + kStepX[action], cell / size + kStepY[action]};
    if (to.x == size) return -1;
    return to.x < 0 || to.y < 0 || to.y == size ? cell : index(to);
  }

  // Probability that a check of a rock from a cell tells the truth.
  double accuracy(int cell, int rock) const {
    const double distance = std::hypot(cell % size - rocks[rock].x, cell / size - rocks[rock].y);
    return 0.5 * (1.0 + std::exp2(-distance / half_efficiency_distance));
  }
};

struct RockSampleAction {
  enum : int { kNorth, kEast, kSouth, kWest, kSample, kCheck };  // rock r is checked by kCheck + r
};

}  // namespace pomdp_crowd_nav
