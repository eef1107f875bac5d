// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/ros/map_conversions.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "pomdp_crowd_nav/ros/conversions.h"

namespace pomdp_crowd_nav {
namespace {

constexpr double kTurnedGrid = 1e-3;  // [rad]
constexpr double kDrawnWithin =
    0.5;                            // cells, an obstacle fills the cells whose centre is this near
constexpr double kRounding = 0.01;  // cells, what a grid's single precision may make of that
constexpr double kFarthest = 1e6;   // [m], of a coordinate and of an edge
constexpr double kFinest = 1e-6;    // [m], of a cell: it vanishes beside no coordinate
constexpr double kMostCells = 1e8;  // of the rectangle around a turned grid

// A blocked grid as a message has it: with a pose in the global frame.
struct PosedGrid {
  const OccupancyGrid& cells;  // in the frame of its own origin
  Pose origin;

  Point toGlobal(const Point& local) const {
    return origin.position + rotated(origin.heading, local);
  }
  Point toLocal(const Point& global) const {
    return rotated(-origin.heading, Point(global - origin.position));
  }
};

size_t cellAt(const OccupancyGrid& grid, const Point& place) {
  const Point cells = (place - grid.origin) / grid.resolution;
  const auto column = static_cast<size_t>(std::clamp<double>(cells.x(), 0.0, grid.columns - 1));
  const auto row = static_cast<size_t>(std::clamp<double>(cells.y(), 0.0, grid.rows - 1));
  return row * grid.columns + column;
}

Point centerOf(const OccupancyGrid& grid, size_t cell) {
  const Point place(static_cast<double>(cell % grid.columns),
                    static_cast<double>(cell / grid.columns));
  return grid.origin + grid.resolution * (place + Point(0.5, 0.5));
}

// The rectangle of a frame's axes around a grid, all of it blocked.
OccupancyGrid rectangleAround(const PosedGrid& grid) {
  const Point size = grid.cells.resolution * Point(grid.cells.columns, grid.cells.rows);
  OccupancyGrid around;
  Point most = around.origin = grid.toGlobal(Point(0.0, 0.0));
  for (const Point& corner : {Point(size.x(), 0.0), Point(0.0, size.y()), size}) {
    around.origin = around.origin.cwiseMin(grid.toGlobal(corner));
    most = most.cwiseMax(grid.toGlobal(corner));
  }
  around.resolution = grid.cells.resolution;
  const Point cells = ((most - around.origin) / around.resolution).array().ceil();
  if (!(cells.prod() <= kMostCells)) {
    throw std::invalid_argument(fmt::format("map: turned, it takes {} x {} cells, more than {}",
                                            cells.x(), cells.y(), kMostCells));
  }
  around.columns = static_cast<int>(cells.x());
  around.rows = static_cast<int>(cells.y());
  around.blocked.assign(static_cast<size_t>(around.columns) * around.rows, 1);
  return around;
}

// By the nearest cell; then every blocked cell blocks the one that holds its centre, for a single
// one may lie between the samples.
OccupancyGrid straightened(const PosedGrid& grid) {
  OccupancyGrid straight = rectangleAround(grid);
  const Point size = grid.cells.resolution * Point(grid.cells.columns, grid.cells.rows);
  for (size_t cell = 0; cell < straight.blocked.size(); ++cell) {
    const Point local = grid.toLocal(centerOf(straight, cell));
    const bool is_on = local.minCoeff() >= 0.0 && (size - local).minCoeff() >= 0.0;
    if (is_on) straight.blocked[cell] = grid.cells.blocked[cellAt(grid.cells, local)];
  }
  for (size_t cell = 0; cell < grid.cells.blocked.size(); ++cell) {
    if (grid.cells.blocked[cell] == 0) continue;
    straight.blocked[cellAt(straight, grid.toGlobal(centerOf(grid.cells, cell)))] = 1;
  }
  return straight;
}

// Throws std::invalid_argument, naming what cannot be of a map.
void validate(const nav_msgs::OccupancyGrid& grid, const std::optional<Pose>& origin) {
  const nav_msgs::MapMetaData& info = grid.info;
  const size_t cells = static_cast<size_t>(info.width) * info.height;
  if (cells == 0 || cells != grid.data.size()) {
    throw std::invalid_argument(fmt::format("map: {} x {} cells announced, {} sent", info.width,
                                            info.height, grid.data.size()));
  }
  if (!origin) {
    throw std::invalid_argument("map: its origin must be finite and its orientation a rotation");
  }
  if (!(origin->position.cwiseAbs().maxCoeff() <= kFarthest)) {
    throw std::invalid_argument(fmt::format("map: its origin must be within {} m, got ({}, {})",
                                            kFarthest, origin->position.x(), origin->position.y()));
  }
  const double edge = static_cast<double>(info.resolution) * std::max(info.width, info.height);
  if (!(info.resolution >= kFinest && edge <= kFarthest)) {
    throw std::invalid_argument(
        fmt::format("map: its resolution must be at least {} m and its edges at most {} m, got {} "
                    "m and {} m",
                    kFinest, kFarthest, info.resolution, edge));
  }
}

}  // namespace

std::shared_ptr<const StaticMap> toStaticMap(const nav_msgs::OccupancyGrid& grid,
                                             const MapPolicy& policy) {
  const std::optional<Pose> origin = toPose(grid.info.origin);
  validate(grid, origin);
  OccupancyGrid blocked;
  blocked.resolution = grid.info.resolution;
  blocked.columns = static_cast<int>(grid.info.width);
  blocked.rows = static_cast<int>(grid.info.height);
  blocked.blocked.reserve(grid.data.size());
  for (const std::int8_t cell : grid.data)
    blocked.blocked.push_back(policy.isBlocked(cell) ? 1 : 0);
  if (std::abs(origin->heading) > kTurnedGrid) {
    blocked = straightened({blocked, *origin});
  } else {
    blocked.origin = origin->position;
  }
  const Point corner = blocked.origin;
  const Point size = blocked.resolution * Point(blocked.columns, blocked.rows);
  StaticMap::Obstacles obstacles;
  obstacles.grid = std::move(blocked);
  return std::make_shared<const StaticMap>(Bounds{corner, Point(corner + size)},
                                           std::move(obstacles));
}

nav_msgs::OccupancyGrid toMessage(const StaticMap& map, double resolution,
                                  const std_msgs::Header& header) {
  const Point size = map.bounds().max - map.bounds().min;
  nav_msgs::OccupancyGrid message;
  message.header = header;
  message.info.map_load_time = header.stamp;
  message.info.resolution = static_cast<float>(resolution);
  message.info.width = static_cast<std::uint32_t>(std::ceil(size.x() / resolution - 1e-6));
  message.info.height = static_cast<std::uint32_t>(std::ceil(size.y() / resolution - 1e-6));
  message.info.origin = toMessage(Pose{map.bounds().min, 0.0});
  for (std::uint32_t row = 0; row < message.info.height; ++row) {
    for (std::uint32_t column = 0; column < message.info.width; ++column) {
      const Point center = map.bounds().min + resolution * Point(column + 0.5, row + 0.5);
      message.data.push_back(map.clearance(center) <= kDrawnWithin * resolution ? 100 : 0);
    }
  }
  return message;
}

bool isDrawingOf(const StaticMap& map, const nav_msgs::OccupancyGrid& grid,
                 const MapPolicy& policy) {
  const double resolution = grid.info.resolution;
  const Point origin(grid.info.origin.position.x, grid.info.origin.position.y);
  const Point size = map.bounds().max - map.bounds().min;
  const Point missing = resolution * Point(grid.info.width, grid.info.height) - size;
  if (grid.data.size() != static_cast<size_t>(grid.info.width) * grid.info.height) return false;
  if (!((origin - map.bounds().min).norm() <= kRounding * resolution)) return false;
  if (!(missing.cwiseAbs().maxCoeff() <= resolution)) return false;
  for (size_t i = 0; i < grid.data.size(); ++i) {
    const Point cell(static_cast<double>(i % grid.info.width) + 0.5,
                     static_cast<double>(i / grid.info.width) + 0.5);
    const double clearance = map.clearance(origin + resolution * cell) / resolution;
    const bool is_blocked = policy.isBlocked(grid.data[i]);
    if (is_blocked && clearance > kDrawnWithin + kRounding) return false;
    if (!is_blocked && clearance < kDrawnWithin - kRounding) return false;
  }
  return true;
}

}  // namespace pomdp_crowd_nav
