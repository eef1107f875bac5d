// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/world/obstacle_index.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace pomdp_crowd_nav {
namespace {

constexpr int kMaxDepth = 8;
constexpr size_t kShapesPerLeaf = 8;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace

double ObstacleIndex::Square::halfDiagonal() const { return M_SQRT2 * half_side; }

int ObstacleIndex::Square::quadrantOf(const Point& point) const {
  return (point.x() > center.x() ? 1 : 0) + (point.y() > center.y() ? 2 : 0);
}

ObstacleIndex::Square ObstacleIndex::Square::quarter(int quadrant) const {
  const double quarter_side = 0.5 * half_side;
  return {center + Point((quadrant & 1) != 0 ? quarter_side : -quarter_side,
                         (quadrant & 2) != 0 ? quarter_side : -quarter_side),
          quarter_side};
}

bool ObstacleIndex::Square::contains(const Point& point) const {
  return (point - center).lpNorm<Eigen::Infinity>() <= half_side;
}

ObstacleIndex::ObstacleIndex(const Bounds& bounds, const std::vector<Circle>& circles,
                             const std::vector<Polygon>& polygons) {
  for (const Circle& circle : circles) {
    shapes_.push_back({circle.center, circle.center, circle.radius, -1});
  }
  for (const Polygon& polygon : polygons) addPolygon(polygon);

  root_ = {0.5 * (bounds.min + bounds.max), 0.5 * (bounds.max - bounds.min).maxCoeff()};
  nodes_.resize(1);
  Candidates& all = nodes_[0].candidates;
  for (size_t i = 0; i < shapes_.size(); ++i) all.shapes.push_back(static_cast<int>(i));
  for (size_t i = 0; i < closed_polygons_.size(); ++i) all.polygons.push_back(static_cast<int>(i));
  split(0, root_, 0);
}

void ObstacleIndex::addPolygon(const Polygon& polygon) {
  const std::vector<Point>& corners = polygon.vertices;
  int closed_index = -1;
  if (polygon.closed) {
    closed_index = static_cast<int>(closed_polygons_.size());
    closed_polygons_.push_back(corners);
    shapes_.push_back({corners.back(), corners.front(), 0.0, closed_index});
  }
  for (size_t i = 1; i < corners.size(); ++i) {
    shapes_.push_back({corners[i - 1], corners[i], 0.0, closed_index});
  }
}

// The root keeps its full list for points off the bounds; other inner nodes give theirs away.
void ObstacleIndex::split(int node, const Square& square, int depth) {
  if (depth == kMaxDepth || nodes_[node].candidates.shapes.size() <= kShapesPerLeaf) return;
  const int first_child = static_cast<int>(nodes_.size());
  nodes_[node].first_child = first_child;
  nodes_.resize(nodes_.size() + 4);
  for (int quadrant = 0; quadrant < 4; ++quadrant) {
    nodes_[first_child + quadrant].candidates =
        narrowed(nodes_[node].candidates, square.quarter(quadrant));
  }
  if (node != 0) nodes_[node].candidates = {};
  for (int quadrant = 0; quadrant < 4; ++quadrant) {
    split(first_child + quadrant, square.quarter(quadrant), depth + 1);
  }
}

// Circles and edges are narrowed apart: inside a polygon the sign of the edges turns.
ObstacleIndex::Candidates ObstacleIndex::narrowed(const Candidates& from,
                                                  const Square& square) const {
  const double margin = square.halfDiagonal() * (1.0 + 1e-9);
  std::vector<double> distances;
  double nearest_circle = kInfinity, nearest_edge = kInfinity;
  for (int shape : from.shapes) {
    distances.push_back(distance(shape, square.center));
    double& nearest = shapes_[shape].radius > 0.0 ? nearest_circle : nearest_edge;
    nearest = std::min(nearest, distances.back());
  }

  Candidates kept;
  kept.inside = from.inside;
  std::vector<int> crossing;  // polygons whose edges may pass through the square
  for (size_t i = 0; i < from.shapes.size(); ++i) {
    const Shape& shape = shapes_[from.shapes[i]];
    const double nearest = shape.radius > 0.0 ? nearest_circle : nearest_edge;
    if (distances[i] <= nearest + 2.0 * margin) kept.shapes.push_back(from.shapes[i]);
    if (distances[i] <= margin && shape.polygon >= 0) crossing.push_back(shape.polygon);
  }
  for (int polygon : from.polygons) {
    if (std::find(crossing.begin(), crossing.end(), polygon) != crossing.end()) {
      kept.polygons.push_back(polygon);
    } else if (isInsidePolygon(square.center, closed_polygons_[polygon])) {
      kept.inside = true;
    }
  }
  return kept;
}

double ObstacleIndex::distance(int shape, const Point& point) const {
  const Shape& s = shapes_[shape];
  return distanceToSegment(point, s.a, s.b) - s.radius;
}

double ObstacleIndex::clearance(const Point& point) const {
  int node = 0;
  if (root_.contains(point)) {
    for (Square square = root_; nodes_[node].first_child >= 0;) {
      const int quadrant = square.quadrantOf(point);
      node = nodes_[node].first_child + quadrant;
      square = square.quarter(quadrant);
    }
  }
  return clearanceAmong(nodes_[node].candidates, point);
}

double ObstacleIndex::clearanceAmong(const Candidates& candidates, const Point& point) const {
  double nearest_circle = kInfinity, nearest_edge = kInfinity;
  for (int shape : candidates.shapes) {
    double& nearest = shapes_[shape].radius > 0.0 ? nearest_circle : nearest_edge;
    nearest = std::min(nearest, distance(shape, point));
  }
  const bool inside =
      candidates.inside ||
      std::any_of(candidates.polygons.begin(), candidates.polygons.end(),
                  [&](int polygon) { return isInsidePolygon(point, closed_polygons_[polygon]); });
  return std::min(nearest_circle, inside ? -nearest_edge : nearest_edge);
}

}  // namespace pomdp_crowd_nav
