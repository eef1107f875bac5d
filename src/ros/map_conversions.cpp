// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/ros/map_conversions.h"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "pomdp_crowd_nav/ros/conversions.h"

namespace pomdp_crowd_nav {
namespace {

constexpr int kOccupied = 65;         // of 100, as map_server's default threshold
constexpr double kTurnedGrid = 1e-3;  // [rad]
constexpr double kDrawnWithin =
    0.5;                            // cells, an obstacle fills the cells whose centre is this near
constexpr double kRounding = 0.01;  // cells, what a grid's single precision may make of that

}  // namespace

std::shared_ptr<const StaticMap> toStaticMap(const nav_msgs::OccupancyGrid& grid) {
  const std::optional<Pose> origin = toPose(grid.info.origin);
  const size_t cells = static_cast<size_t>(grid.info.width) * grid.info.height;
  if (cells == 0 || cells != grid.data.size()) {
    throw std::invalid_argument(fmt::format("map: {} x {} cells announced, {} sent",
                                            grid.info.width, grid.info.height, grid.data.size()));
  }
  if (!origin || std::abs(origin->heading) > kTurnedGrid) {
    throw std::invalid_argument("map: its origin must be finite and not turned");
  }
  OccupancyGrid blocked;
  blocked.origin = origin->position;
  blocked.resolution = grid.info.resolution;
  blocked.columns = static_cast<int>(grid.info.width);
  blocked.rows = static_cast<int>(grid.info.height);
  for (const int cell : grid.data) blocked.blocked.push_back(cell < 0 || cell >= kOccupied);
  const Point size = blocked.resolution * Point(blocked.columns, blocked.rows);
  StaticMap::Obstacles obstacles;
  obstacles.grid = std::move(blocked);
  return std::make_shared<const StaticMap>(Bounds{origin->position, Point(origin->position + size)},
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

bool isDrawingOf(const StaticMap& map, const nav_msgs::OccupancyGrid& grid) {
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
    const bool is_blocked = grid.data[i] < 0 || grid.data[i] >= kOccupied;
    if (is_blocked && clearance > kDrawnWithin + kRounding) return false;
    if (!is_blocked && clearance < kDrawnWithin - kRounding) return false;
  }
  return true;
}

}  // namespace pomdp_crowd_nav
