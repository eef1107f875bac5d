// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/ros/prior_layers.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "pomdp_crowd_nav/ros/conversions.h"
#include "pomdp_crowd_nav/ros/marker_shapes.h"
#include "pomdp_crowd_nav/ros/markers.h"

namespace pomdp_crowd_nav {
namespace {

using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

constexpr float kUnreachable = 1e6F;  // see NavigationCell
constexpr std::int8_t kUnknown = -1, kFarthest = 98, kMargin = 99, kObstacle = 100;

// The field's cells, every `stride`-th of them in both directions.
struct Sampling {
  int stride = 1;
  int columns = 1;
  int rows = 1;
};

Sampling samplingOf(const CellRaster& raster) {
  const long columns = raster.columns;
  const long rows = static_cast<long>(raster.last_row) + 1;
  const double excess = static_cast<double>(columns * rows) / kMaxArrivalCells;
  const int stride = std::max(1, static_cast<int>(std::ceil(std::sqrt(excess))));
  return {stride, static_cast<int>((columns + stride - 1) / stride),
          static_cast<int>((rows + stride - 1) / stride)};
}

std::vector<NavigationCell> sampled(const NavigationField& field, const Sampling& sampling) {
  const CellRaster& raster = field.raster();
  const float cell = static_cast<float>(sampling.stride) / raster.cells_per_meter;
  std::vector<NavigationCell> cells;
  cells.reserve(static_cast<size_t>(sampling.columns) * sampling.rows);
  for (int row = 0; row < sampling.rows; ++row) {
    const float y = raster.min_y + (static_cast<float>(row) + 0.5F) * cell;
    for (int column = 0; column < sampling.columns; ++column) {
      cells.push_back(field.at(raster.min_x + (static_cast<float>(column) + 0.5F) * cell, y));
    }
  }
  return cells;
}

std::int8_t shadeOf(const NavigationCell& cell, double margin, float longest) {
  if (cell.clearance <= 0.0F) return kObstacle;
  if (cell.distance_to_goal >= kUnreachable) return kUnknown;
  if (cell.clearance < margin) return kMargin;
  const float share = longest > 0.0F ? cell.distance_to_goal / longest : 0.0F;
  return static_cast<std::int8_t>(
      std::clamp(std::lround(1.0F + (kFarthest - 1.0F) * share), 1L, static_cast<long>(kFarthest)));
}

// Whether the shortest way from one end leads over the edge.
bool isOnShortestWay(const Roadmap::Edge& edge, const std::vector<double>& distances) {
  constexpr double kRounding = 1e-6;  // [m]
  const double difference = std::abs(distances[edge.from] - distances[edge.to]);
  return std::isfinite(difference) && difference > edge.length - kRounding;
}

}  // namespace

nav_msgs::OccupancyGrid arrivalTimeGrid(const NavigationField& field, double margin,
                                        const std_msgs::Header& header) {
  const Sampling sampling = samplingOf(field.raster());
  const std::vector<NavigationCell> cells = sampled(field, sampling);
  float longest = 0.0F;
  for (const NavigationCell& cell : cells) {
    const bool counts = cell.clearance > 0.0F && cell.clearance >= margin;
    if (counts && cell.distance_to_goal < kUnreachable) {
      longest = std::max(longest, cell.distance_to_goal);
    }
  }
  nav_msgs::OccupancyGrid grid;
  grid.header = header;
  grid.info.map_load_time = header.stamp;
  grid.info.resolution = static_cast<float>(sampling.stride) / field.raster().cells_per_meter;
  grid.info.width = static_cast<std::uint32_t>(sampling.columns);
  grid.info.height = static_cast<std::uint32_t>(sampling.rows);
  grid.info.origin = toMessage(Pose{Point(field.raster().min_x, field.raster().min_y), 0.0});
  grid.data.reserve(cells.size());
  for (const NavigationCell& cell : cells) grid.data.push_back(shadeOf(cell, margin, longest));
  return grid;
}

MarkerArray roadmapMarkers(const RoadmapPrior& prior, double symbol_size,
                           const std_msgs::Header& header) {
  MarkerBuilder builder(header);
  const Roadmap& roadmap = *prior.roadmap();
  const std::vector<Point>& places = roadmap.milestones();
  const std::vector<double> distances = roadmap.distancesTo(prior.goal());
  Marker& edges = builder.beginList("edges", Marker::LINE_LIST, 0.08 * symbol_size, 0.015);
  const size_t stride = roadmap.edges().size() / (kMaxRoadmapEdges + 1) + 1;
  for (size_t i = 0; i < roadmap.edges().size(); i += stride) {
    const Roadmap::Edge& edge = roadmap.edges()[i];
    addLine(places[edge.from], places[edge.to], color(0.72, 0.75, 0.80), edges);
  }
  Marker& ways = builder.beginList("shortest_ways", Marker::LINE_LIST, 0.25 * symbol_size, 0.02);
  const auto green = color(0.0, 0.50, 0.30);
  for (const Roadmap::Edge& edge : roadmap.edges()) {
    if (isOnShortestWay(edge, distances)) addLine(places[edge.from], places[edge.to], green, ways);
  }
  for (size_t i = 0; i < places.size(); ++i) {
    const bool is_joined = (places[i] - prior.goal()).norm() > distances[i] - 1e-6;
    if (is_joined) addLine(places[i], prior.goal(), green, ways);
  }
  Marker& vertices = builder.beginList("milestones", Marker::POINTS, 0.5 * symbol_size, 0.025);
  for (const Point& place : places) addPoint(place, color(0.15, 0.20, 0.30), vertices);
  return builder.take();
}

}  // namespace pomdp_crowd_nav
