// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "pomdp_crowd_nav/world/geometry.h"

namespace pomdp_crowd_nav {

// Axis-aligned rectangle in which the robot may drive.
struct Bounds {
  Point min{0.0, 0.0};      // [m]
  Point max{100.0, 100.0};  // [m]

  bool contains(const Point& p) const {
    return p.x() >= min.x() && p.x() <= max.x() && p.y() >= min.y() && p.y() <= max.y();
  }
};

struct Circle {
  Point center{0.0, 0.0};  // [m]
  double radius = 0.0;     // [m]
};

// A closed polygon is solid; an open one is a wall of no thickness.
struct Polygon {
  std::vector<Point> vertices;  // [m]
  bool closed = true;
};

// Cells row by row from the lower left corner, as in nav_msgs/OccupancyGrid.
struct OccupancyGrid {
  Point origin{0.0, 0.0};     // [m], corner of cell (0, 0)
  double resolution = 0.1;    // [m] per cell
  int columns = 0;            // cells along x
  int rows = 0;               // cells along y
  std::vector<char> blocked;  // rows * columns, non-zero where the robot must not be
};

class ObstacleIndex;

// What stands still: a rectangle to drive in and the obstacles inside it.
//
// Immutable and thread-safe; copies share their tables. The border of the bounds is no obstacle:
// leaving the field is a matter of `bounds().contains`, clearance counts obstacles only.
class StaticMap {
 public:
  struct Obstacles {
    std::vector<Circle> circles;
    std::vector<Polygon> polygons;
    std::optional<OccupancyGrid> grid;
  };

  // Throws std::invalid_argument on empty bounds, a radius that is not positive, a polygon of
  // fewer than 2 (open) or 3 (closed) vertices, or a grid whose size does not match its cells.
  StaticMap(const Bounds& bounds, Obstacles obstacles);

  const Bounds& bounds() const { return bounds_; }
  const Obstacles& obstacles() const { return *obstacles_; }
  bool hasObstacles() const { return has_obstacles_; }

  // Distance to the nearest obstacle [m]: exact for circles and polygons, to the centre of the
  // nearest blocked cell less half a cell for grids, taken at the centre of the cell that holds
  // the point (off the grid: a lower limit). Zero or less inside one: minus the distance to the
  // circle or the nearest polygon edge. Infinite on a map without obstacles.
  double clearance(const Point& point) const;

 private:
  double gridClearance(const Point& point) const;

  Bounds bounds_;
  std::shared_ptr<const Obstacles> obstacles_;
  bool has_obstacles_ = false;
  std::shared_ptr<const ObstacleIndex> index_;  // of circles and polygons
  // [m], per grid cell; null when none is blocked
  std::shared_ptr<const std::vector<float>> grid_distance_;
};

}  // namespace pomdp_crowd_nav
