// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/ros/markers.h"

#include <algorithm>
#include <cmath>

#include "pomdp_crowd_nav/ros/marker_shapes.h"

namespace pomdp_crowd_nav {
namespace {

using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

// From red at 0 over yellow to green at 1.
std_msgs::ColorRGBA valueColor(double share) {
  const double s = std::clamp(share, 0.0, 1.0);
  return color(std::min(1.0, 2.0 - 2.0 * s) * 0.9, std::min(1.0, 2.0 * s) * 0.75, 0.05);
}

void addPolygon(const Polygon& polygon, const std_msgs::ColorRGBA& color, Marker& lines) {
  const size_t count = polygon.vertices.size();
  const size_t edges = polygon.closed ? count : count - 1;
  for (size_t i = 0; i < edges; ++i) {
    addLine(polygon.vertices[i], polygon.vertices[(i + 1) % count], color, lines);
  }
}

Polygon outline(const Bounds& bounds) {
  return {
      {bounds.min, {bounds.max.x(), bounds.min.y()}, bounds.max, {bounds.min.x(), bounds.max.y()}},
      true};
}

struct ValueRange {
  float low = 0.0F;
  float high = 0.0F;
  double share(float value) const {
    return high > low ? static_cast<double>((value - low) / (high - low)) : 1.0;
  }
};

int deepestOf(const TreeView& view) {
  int depth = 1;
  for (const TreeEdge& edge : view.edges) depth = std::max(depth, edge.depth);
  return depth;
}

// The middle nine tenths of all values, so that a few crashes do not make the rest one green.
ValueRange valueRange(const TreeView& view) {
  std::vector<float> values;
  for (const TreeEdge& edge : view.edges) values.push_back(edge.value);
  if (values.empty()) return {};
  std::sort(values.begin(), values.end());
  const size_t tail = values.size() / 20;
  return {values[tail], values[values.size() - 1 - tail]};
}

}  // namespace

std_msgs::ColorRGBA destinationColor(size_t index, double alpha) {
  // Told apart by people who do not see red and green apart as well.
  constexpr double kColors[][3] = {{0.00, 0.45, 0.70}, {0.90, 0.60, 0.00}, {0.55, 0.25, 0.60},
                                   {0.20, 0.70, 0.85}, {0.80, 0.35, 0.55}, {0.45, 0.35, 0.15},
                                   {0.35, 0.40, 0.45}, {0.10, 0.20, 0.50}};
  const double* c = kColors[index % (sizeof(kColors) / sizeof(kColors[0]))];
  return color(c[0], c[1], c[2], alpha);
}

double symbolSize(const Bounds& field) {
  return std::clamp(0.007 * (field.max - field.min).norm(), 0.4, 1.0);
}

MarkerArray worldMarkers(const World& world, double tolerance, const std_msgs::Header& header) {
  MarkerBuilder builder(header);
  const double size = symbolSize(world.bounds);
  Marker& edges = builder.beginList("outlines", Marker::LINE_LIST, 0.3 * size, 0.02);
  const auto grey = color(0.25, 0.27, 0.30);
  addPolygon(outline(world.bounds), grey, edges);
  for (const Polygon& polygon : world.obstacles.polygons) addPolygon(polygon, grey, edges);
  for (const Circle& circle : world.obstacles.circles) {
    addCircle(circle.center, circle.radius, grey, edges);
  }
  addCircle(world.goal, tolerance, color(0.0, 0.55, 0.25), edges);
  Marker& areas = builder.beginList("areas", Marker::TRIANGLE_LIST, 1.0, 0.01);
  for (const Circle& circle : world.obstacles.circles) {
    addDisc(circle.center, circle.radius, color(0.62, 0.64, 0.67), areas);
  }
  addDisc(world.goal, tolerance, color(0.0, 0.75, 0.35, 0.6), areas);
  addDisc(world.start.position, size, color(0.5, 0.5, 0.5, 0.6), areas);
  for (size_t i = 0; i < world.destinations.size(); ++i) {
    addDisc(world.destinations[i], 1.6 * size, destinationColor(i, 0.8), areas);
  }
  return builder.take();
}

MarkerArray crowdMarkers(const std::vector<Walker>& walkers, double symbol_size,
                         const std_msgs::Header& header) {
  MarkerBuilder builder(header);
  Marker& people = builder.beginList("really_there", Marker::SPHERE_LIST, 0.8 * symbol_size, 0.3);
  for (const Walker& walker : walkers) {
    addPoint(walker.position, color(0.66, 0.68, 0.71), people);
  }
  return builder.take();
}

MarkerArray treeMarkers(const TreeScene& scene, double symbol_size,
                        const std_msgs::Header& header) {
  MarkerBuilder builder(header);
  const ValueRange range = valueRange(scene.view);
  const int deepest = deepestOf(scene.view);
  Marker& tree = builder.beginList("tree", Marker::LINE_LIST, 0.12 * symbol_size, 0.08);
  // The first edges weigh most: they come last, on top.
  for (size_t i = scene.view.edges.size(); i-- > 0;) {
    const TreeEdge& edge = scene.view.edges[i];
    const double fade = (edge.depth - 1) / static_cast<double>(deepest);
    addLine(edge.from, edge.to, paled(valueColor(range.share(edge.value)), 1.0 - 0.55 * fade),
            tree);
  }
  Marker& rollouts = builder.beginList("rollouts", Marker::LINE_LIST, 0.15 * symbol_size, 0.07);
  for (const auto& path : scene.view.rollouts) {
    addDashes(path, 1.2 * symbol_size, color(0.42, 0.42, 0.46), rollouts);
  }
  Marker& chosen = builder.beginList("chosen", Marker::TRIANGLE_LIST, 1.0, 0.10);
  const auto magenta = color(0.86, 0.12, 0.47);
  for (size_t i = 1; i < scene.chosen.size(); ++i) {
    addStroke({scene.chosen[i - 1], scene.chosen[i], 0.4 * symbol_size}, magenta, chosen);
    addDisc(scene.chosen[i], 0.3 * symbol_size, magenta, chosen);
  }
  return builder.take();
}

}  // namespace pomdp_crowd_nav
