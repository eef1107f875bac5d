// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "pomdp_crowd_nav/prior/line_of_sight.h"
#include "pomdp_crowd_nav/sim/world_file.h"

namespace pomdp_crowd_nav {

// Where the robot of OmniscientBound may be and how it gets from place to place, people left aside:
// a lattice along the line from start to goal, with ways in many directions and straight to the
// goal.
class BoundLattice {
 public:
  struct Params {
    double obstacle_clearance = 3.0;  // [m]
    double goal_tolerance = 1.0;      // [m]
    double spacing = 0.5;             // [m]
    int reach = 8;                    // longest way, in spacings
  };
  struct Offset {
    int columns = 0, rows = 0;
    Point way{0.0, 0.0};  // [m]
    double length = 0.0;  // [m]
  };

  BoundLattice(const World& world, const Params& params);

  const LineOfSight& sight() const { return sight_; }
  const std::vector<Offset>& offsets() const { return offsets_; }
  size_t size() const { return clearances_.size(); }
  const Point& start() const { return start_; }
  size_t startNode() const { return start_node_; }
  Point place(size_t node) const;
  std::optional<size_t> neighbour(size_t node, const Offset& offset) const;
  bool isOpen(size_t node, const Offset& offset, size_t other) const;
  bool seesGoal(size_t node) const { return sees_goal_[node] != 0; }
  double wayFrom(size_t node) const { return ways_[node]; }  // [m], infinite without a way

  double distanceToGoal(const Point& place) const;  // [m], straight, to within the tolerance
  Point arrivalFrom(const Point& place) const;      // where a straight drive to it ends

 private:
  void layOut();
  void listOffsets();
  void measureWays();

  Params params_;
  LineOfSight sight_;
  Point start_, goal_;
  Point along_, across_;  // unit vectors
  int columns_ = 0, rows_ = 0;
  Point corner_;  // [m], of node (0, 0)
  size_t start_node_ = 0;
  std::vector<Offset> offsets_;
  std::vector<float> clearances_;  // [m], per node; negative where the robot must not be
  std::vector<char> sees_goal_;
  std::vector<double> ways_;  // [m], per node, to the goal
};

}  // namespace pomdp_crowd_nav
