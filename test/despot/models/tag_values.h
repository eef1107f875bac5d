// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "tag_floor.h"

namespace pomdp_crowd_nav {

// Expected returns of Tag from every pair of cells: of the best chase of an opponent in full view,
// which no policy betters, and of two rounds of the floor. Computed once, shared by all searches.
class TagValues {
 public:
  static constexpr float kTagged = 10.0F;
  static constexpr float kMissed = -10.0F;
  static constexpr float kMoving = -1.0F;
  static constexpr int kRounds = 2;

  explicit TagValues(double discount) : discount_(discount) {
    for (int i = 0; i < TagFloor::kCells * TagFloor::kCells; ++i) {
      moves_[i] = opponentMoves(i / TagFloor::kCells, i % TagFloor::kCells);
    }
    chase_.fill(kTagged);  // from above: a bound after every sweep
    for (int sweep = 0; sweep < kSweeps; ++sweep) improveChase();
    for (int round = 0; round < kRounds; ++round) {
      rounds_[round].fill(never());  // from below, likewise
      for (int sweep = 0; sweep < kSweeps; ++sweep) improveRound(round);
    }
  }

  // opponentMoves, out of a table.
  const std::array<double, 5>& moves(int robot, int opponent) const {
    return moves_[index(robot, opponent)];
  }

  // Of moving for ever.
  double never() const { return static_cast<double>(kMoving) / (1.0 - discount_); }
  double chase(int robot, int opponent) const { return chase_[index(robot, opponent)]; }

  // Of walking round the floor one way or the other, and tagging the opponent on sight.
  double round(int which, int robot, int opponent) const {
    return rounds_[which][index(robot, opponent)];
  }

  // Where such a round goes next.
  static int directionOf(int which, int robot) {
    static constexpr const char* kWays[kRounds][5] = {
        {"EEEEEEEEEN", "SWWWWWWNWW", "     SWN  ", "     SWN  ", "     SWW  "},
        {"NWWWWWWWWW", "EEEEENEEES", "     NES  ", "     NES  ", "     EES  "}};
    return static_cast<int>(
        std::string("NESW").find(kWays[which][TagFloor::y(robot)][TagFloor::x(robot)]));
  }

 private:
  using Values = std::array<double, TagFloor::kCells * TagFloor::kCells>;
  static constexpr int kSweeps = 400;  // 0.95^400 is 1e-9

  static int index(int robot, int opponent) { return robot * TagFloor::kCells + opponent; }

  // Expected value after the robot has gone to `to` and the opponent away from where it was.
  double after(const Values& values, int robot, int opponent, int to) const {
    double sum = 0.0;
    for (int d = 0; d <= TagFloor::kStay; ++d) {
      sum += moves(robot, opponent)[d] * values[index(to, TagFloor::moved(opponent, d))];
    }
    return sum;
  }

  void improveChase() {
    for (int robot = 0; robot < TagFloor::kCells; ++robot) {
      for (int opponent = 0; opponent < TagFloor::kCells; ++opponent) {
        double best = robot == opponent ? kTagged : never();
        for (int d = 0; d < TagFloor::kDirections; ++d) {
          const int to = TagFloor::moved(robot, d);
          best = std::max(best, kMoving + discount_ * after(chase_, robot, opponent, to));
        }
        chase_[index(robot, opponent)] = best;
      }
    }
  }

  void improveRound(int round) {
    for (int robot = 0; robot < TagFloor::kCells; ++robot) {
      const int to = TagFloor::moved(robot, directionOf(round, robot));
      for (int opponent = 0; opponent < TagFloor::kCells; ++opponent) {
        rounds_[round][index(robot, opponent)] =
            robot == opponent ? kTagged
                              : kMoving + discount_ * after(rounds_[round], robot, opponent, to);
      }
    }
  }

  double discount_;
  std::array<std::array<double, 5>, TagFloor::kCells * TagFloor::kCells> moves_{};
  Values chase_{};
  std::array<Values, kRounds> rounds_{};
};

}  // namespace pomdp_crowd_nav
