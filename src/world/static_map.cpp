// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/world/static_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <stdexcept>
#include <utility>

#include "pomdp_crowd_nav/world/obstacle_index.h"

namespace pomdp_crowd_nav {
namespace {

[[noreturn]] void reject(const std::string& reason) {
  throw std::invalid_argument("map: " + reason);
}

void validate(const Bounds& bounds) {
  const Point size = bounds.max - bounds.min;
  if (size.allFinite() && (size.array() > 0.0).all()) return;
  reject(fmt::format("bounds must not be empty, got ({}, {}) to ({}, {})", bounds.min.x(),
                     bounds.min.y(), bounds.max.x(), bounds.max.y()));
}

void validate(const Circle& circle, size_t index) {
  if (!(circle.radius > 0.0 && std::isfinite(circle.radius))) {
    reject(fmt::format("radius of circle {} must be positive, got {}", index, circle.radius));
  }
  if (!circle.center.allFinite()) {
    reject(fmt::format("centre of circle {} must be finite, got ({}, {})", index, circle.center.x(),
                       circle.center.y()));
  }
}

void validate(const Polygon& polygon, size_t index) {
  const size_t least = polygon.closed ? 3 : 2;
  if (polygon.vertices.size() < least) {
    reject(fmt::format("{} polygon {} needs at least {} vertices, got {}",
                       polygon.closed ? "closed" : "open", index, least, polygon.vertices.size()));
  }
  for (const Point& vertex : polygon.vertices) {
    if (vertex.allFinite()) continue;
    reject(fmt::format("vertices of polygon {} must be finite, got ({}, {})", index, vertex.x(),
                       vertex.y()));
  }
}

void validate(const OccupancyGrid& grid) {
  if (!(grid.resolution > 0.0 && std::isfinite(grid.resolution))) {
    reject(fmt::format("grid resolution must be positive, got {}", grid.resolution));
  }
  if (!grid.origin.allFinite()) {
    reject(
        fmt::format("grid origin must be finite, got ({}, {})", grid.origin.x(), grid.origin.y()));
  }
  if (grid.columns <= 0 || grid.rows <= 0 ||
      grid.blocked.size() != static_cast<size_t>(grid.columns) * static_cast<size_t>(grid.rows)) {
    reject(fmt::format("grid of {} columns by {} rows does not match its {} cells", grid.columns,
                       grid.rows, grid.blocked.size()));
  }
}

// Distance of each cell's centre to the nearest blocked cell [m]; empty when none is blocked.
std::vector<float> distanceToBlocked(const OccupancyGrid& grid) {
  const auto is_blocked = [](char cell) { return cell != 0; };
  if (std::none_of(grid.blocked.begin(), grid.blocked.end(), is_blocked)) return {};

  cv::Mat free_space(grid.rows, grid.columns, CV_8U);
  std::transform(grid.blocked.begin(), grid.blocked.end(), free_space.begin<uchar>(),
                 [](char cell) { return static_cast<uchar>(cell != 0 ? 0 : 255); });
  cv::Mat cells;
  cv::distanceTransform(free_space, cells, cv::DIST_L2, cv::DIST_MASK_PRECISE, CV_32F);

  std::vector<float> distance;
  distance.reserve(grid.blocked.size());
  std::transform(cells.begin<float>(), cells.end<float>(), std::back_inserter(distance),
                 [&](float d) { return static_cast<float>((d - 0.5) * grid.resolution); });
  return distance;
}

}  // namespace

StaticMap::StaticMap(const Bounds& bounds, Obstacles obstacles)
    : bounds_(bounds), obstacles_(std::make_shared<const Obstacles>(std::move(obstacles))) {
  validate(bounds_);
  const std::vector<Circle>& circles = obstacles_->circles;
  const std::vector<Polygon>& polygons = obstacles_->polygons;
  for (size_t i = 0; i < circles.size(); ++i) validate(circles[i], i);
  for (size_t i = 0; i < polygons.size(); ++i) validate(polygons[i], i);
  index_ = std::make_shared<const ObstacleIndex>(bounds_, circles, polygons);
  if (obstacles_->grid) {
    validate(*obstacles_->grid);
    std::vector<float> distance = distanceToBlocked(*obstacles_->grid);
    if (!distance.empty()) {
      grid_distance_ = std::make_shared<const std::vector<float>>(std::move(distance));
    }
  }
  has_obstacles_ = !circles.empty() || !polygons.empty() || grid_distance_ != nullptr;
}

double StaticMap::clearance(const Point& point) const {
  if (!grid_distance_) return index_->clearance(point);
  if (index_->isEmpty()) return gridClearance(point);
  return std::min(index_->clearance(point), gridClearance(point));
}

// Off the grid: the nearest point of the rectangle of cell centres is never at less than a right
// angle from any blocked centre, so the two legs give a distance that is never too large.
double StaticMap::gridClearance(const Point& point) const {
  const OccupancyGrid& grid = *obstacles_->grid;
  const Eigen::Array2d size(grid.columns, grid.rows);
  const Eigen::Array2d place = (point - grid.origin).array() / grid.resolution;  // [cells]
  const Eigen::Array2d cell = place.max(0.0).min(size - 1.0);
  const double distance = (*grid_distance_)[static_cast<size_t>(cell.y()) * grid.columns +
                                            static_cast<size_t>(cell.x())];
  if ((place >= 0.0).all() && (place <= size).all()) return distance;

  const double half_cell = 0.5 * grid.resolution;
  const Eigen::Array2d edge = place.max(0.5).min(size - 0.5);
  const double beyond = grid.resolution * (place - edge).matrix().norm();
  return std::hypot(beyond, std::max(0.0, distance)) - half_cell;
}

}  // namespace pomdp_crowd_nav
