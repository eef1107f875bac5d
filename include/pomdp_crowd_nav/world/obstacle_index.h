// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "pomdp_crowd_nav/world/static_map.h"

namespace pomdp_crowd_nav {

// Exact distance to the nearest circle or polygon edge, fast on maps with many of them.
//
// A quadtree over the bounds whose leaves list the few shapes that can be the nearest one to a
// point in them. Distance changes by at most the way between two points, so with the centre of a
// cell and its half diagonal h, no shape farther from the centre than the nearest plus 2h counts.
class ObstacleIndex {
 public:
  ObstacleIndex() = default;
  ObstacleIndex(const Bounds& bounds, const std::vector<Circle>& circles,
                const std::vector<Polygon>& polygons);

  // [m]: negative by the distance to the border inside a circle and to the nearest edge inside a
  // closed polygon; infinite without shapes. Points off the bounds are looked up one by one.
  double clearance(const Point& point) const;

  bool isEmpty() const { return shapes_.empty(); }

 private:
  // A circle is the segment from its centre to its centre, with a radius.
  struct Shape {
    Point a, b;     // [m]
    double radius;  // [m], 0 for an edge
    int polygon;    // index among the closed polygons, -1 for circles and walls
  };
  struct Candidates {
    std::vector<int> shapes, polygons;
    bool inside = false;  // the whole cell lies inside a polygon that is no longer listed
  };
  struct Node {
    int first_child = -1;  // of four; -1 at a leaf
    Candidates candidates;
  };
  struct Square {
    Point center{0.0, 0.0};
    double half_side = 0.0;
    double halfDiagonal() const;
    Square quarter(int quadrant) const;
    int quadrantOf(const Point& point) const;
    bool contains(const Point& point) const;
  };

  void addPolygon(const Polygon& polygon);
  void split(int node, const Square& square, int depth);
  Candidates narrowed(const Candidates& from, const Square& square) const;
  double clearanceAmong(const Candidates& candidates, const Point& point) const;
  double distance(int shape, const Point& point) const;

  std::vector<Shape> shapes_;
  std::vector<std::vector<Point>> closed_polygons_;
  Square root_;
  std::vector<Node> nodes_;
};

}  // namespace pomdp_crowd_nav
