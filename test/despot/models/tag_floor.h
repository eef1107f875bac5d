// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <vector>

namespace pomdp_crowd_nav {

// Where Tag is played (Pineau, Gordon, Thrun 2003): a corridor of 10 x 2 cells and a room of 3 x 3
// north of its columns 5 to 7. Cells count from the corridor's south-west, row by row.
class TagFloor {
 public:
  static constexpr int kCells = 29;
  enum Direction { kNorth, kEast, kSouth, kWest, kStay };
  static constexpr int kDirections = 4;

  // -1 outside.
  static constexpr int cellAt(int x, int y) {
    if (y >= 0 && y < 2 && x >= 0 && x < 10) return 10 * y + x;
    return y >= 2 && y < 5 && x >= 5 && x < 8 ? 20 + 3 * (y - 2) + x - 5 : -1;
  }
  static constexpr int x(int cell) { return cell < 20 ? cell % 10 : 5 + (cell - 20) % 3; }
  static constexpr int y(int cell) { return cell < 20 ? cell / 10 : 2 + (cell - 20) / 3; }

  // The same cell where a wall is in the way.
  static constexpr int moved(int cell, int direction) {
    constexpr int kStepX[] = {0, 1, 0, -1, 0};
    constexpr int kStepY[] = {1, 0, -1, 0, 0};
    const int to = cellAt(x(cell) + kStepX[direction], y(cell) + kStepY[direction]);
    return to < 0 ? cell : to;
  }
};

// Where the opponent goes, by direction, kStay included: away from the robot with 0.4 along x and
// 0.4 along y, half of it to either side where the two are level, else it stays. It stays also
// when a wall is in the way.
inline std::array<double, 5> opponentMoves(int robot, int opponent) {
  std::array<double, 5> probability{};
  const int dx = TagFloor::x(opponent) - TagFloor::x(robot);
  const int dy = TagFloor::y(opponent) - TagFloor::y(robot);
  probability[TagFloor::kEast] = dx > 0 ? 0.4 : (dx == 0 ? 0.2 : 0.0);
  probability[TagFloor::kWest] = 0.4 - probability[TagFloor::kEast];
  probability[TagFloor::kNorth] = dy > 0 ? 0.4 : (dy == 0 ? 0.2 : 0.0);
  probability[TagFloor::kSouth] = 0.4 - probability[TagFloor::kNorth];
  probability[TagFloor::kStay] = 0.2;
  for (int d = 0; d < TagFloor::kDirections; ++d) {
    if (TagFloor::moved(opponent, d) != opponent) continue;
    probability[TagFloor::kStay] += probability[d];
    probability[d] = 0.0;
  }
  return probability;
}

}  // namespace pomdp_crowd_nav
