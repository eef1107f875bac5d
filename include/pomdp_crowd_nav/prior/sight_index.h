// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "pomdp_crowd_nav/prior/line_of_sight.h"

namespace pomdp_crowd_nav {

// A place to head for, and how long the way is from there.
struct Waypoint {
  Point position{0.0, 0.0};       // [m]
  double distance_to_goal = 0.0;  // [m], finite; 0 at the goal only
};

// Finds the waypoint in sight with the shortest way over it to the goal, fast wherever one stands
// outside the clearance.
//
// A quadtree over the bounds of the map whose leaves list the few waypoints that can be the best
// one of a point in them: not out of sight of the whole square, and not beaten everywhere in it by
// another one that is in sight of all of it.
class SightIndex {
 public:
  // `sight` must outlive the index.
  SightIndex(const LineOfSight& sight, std::vector<Waypoint> waypoints);

  const std::vector<Waypoint>& waypoints() const { return waypoints_; }

  // Index of the waypoint; nothing where none is in sight, off the bounds and inside the clearance,
  // but for LineOfSight::kShortfall. Never the waypoint on which one stands, unless it is the goal.
  std::optional<int> bestFrom(const Point& position) const;

 private:
  struct Square {
    Point center{0.0, 0.0};
    double half_side = 0.0;
    Square quarter(int quadrant) const;
  };
  struct Node {
    int first_child = -1;  // of four; -1 at a leaf
    std::vector<int> candidates;
  };

  void split(int node, const Square& square);
  std::vector<int> narrowed(const std::vector<int>& candidates, const Square& square) const;
  bool hasFreePlaces(const Square& square) const;
  int leafAt(const Point& position) const;
  double wayOver(int waypoint, const Point& from) const;

  const LineOfSight& sight_;
  std::vector<Waypoint> waypoints_;
  double smallest_side_;  // [m]
  Square root_;
  std::vector<Node> nodes_;
};

}  // namespace pomdp_crowd_nav
