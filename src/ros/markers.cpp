// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/ros/markers.h"

#include <algorithm>
#include <cmath>

#include "pomdp_crowd_nav/ros/marker_shapes.h"

namespace pomdp_crowd_nav {
namespace {

using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

constexpr int kFadeDepth = 12;  // edges this deep and deeper are the faintest

// From red at 0 over yellow to green at 1.
std_msgs::ColorRGBA valueColor(double share, double alpha) {
  const double s = std::clamp(share, 0.0, 1.0);
  return color(std::min(1.0, 2.0 - 2.0 * s) * 0.9, std::min(1.0, 2.0 * s) * 0.75, 0.05, alpha);
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

// How far above that of a destination in a uniform belief the largest probability is, from 0 to 1.
double certainty(const IntentionBelief& intention) {
  const double count = static_cast<double>(intention.probabilities().size());
  if (count < 2.0) return 1.0;
  const double best = intention.probability(intention.mostLikely());
  return std::clamp((best - 1.0 / count) / (1.0 - 1.0 / count), 0.0, 1.0);
}

struct ValueRange {
  float low = 0.0F;
  float high = 0.0F;
  double share(float value) const {
    return high > low ? static_cast<double>((value - low) / (high - low)) : 1.0;
  }
};

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

MarkerArray crowdMarkers(const CrowdScene& scene, const std_msgs::Header& header) {
  MarkerBuilder builder(header);
  const double size = scene.symbol_size;
  Marker& people = builder.beginList("people", Marker::SPHERE_LIST, 0.8 * size, 0.3);
  for (const Walker& walker : scene.walkers) {
    addPoint(walker.position, color(0.62, 0.64, 0.67), people);
  }
  Marker& trail = builder.beginList("driven", Marker::LINE_LIST, 0.35 * size, 0.03);
  for (size_t i = 1; i < scene.trail.size(); ++i) {
    addLine(scene.trail[i - 1], scene.trail[i], color(0.15, 0.35, 0.95), trail);
  }
  Marker& body = builder.beginList("robot", Marker::LINE_LIST, 0.25 * size, 0.05);
  const Point nose = scene.robot.position + scene.robot_radius * unitVector(scene.robot.heading);
  addCircle(scene.robot.position, scene.robot_radius, color(0.1, 0.2, 0.7), body);
  addLine(scene.robot.position, nose, color(0.1, 0.2, 0.7), body);
  return builder.take();
}

MarkerArray beliefMarkers(const BeliefScene& scene, const std_msgs::Header& header) {
  MarkerBuilder builder(header);
  const double size = scene.symbol_size;
  const auto colorOf = [](const IntentionBelief& intention) {
    const double alpha = 0.2 + 0.8 * certainty(intention);
    const size_t likely = intention.mostLikely();
    if (likely == IntentionBelief::kStanding) return color(0.0, 0.0, 0.0, alpha);
    if (likely == IntentionBelief::kElsewhere) return color(0.45, 0.45, 0.45, alpha);
    return destinationColor(likely, alpha);
  };
  Marker& discs = builder.beginList("likeliest_destination", Marker::SPHERE_LIST, size, 0.4);
  for (const PersonBelief& person : scene.crowd.people) {
    addPoint(person.position, colorOf(person.intention), discs);
  }
  Marker& ways = builder.beginList("likeliest_way", Marker::LINE_LIST, 0.2 * size, 0.06);
  for (const PersonBelief& person : scene.crowd.people) {
    const size_t likely = person.intention.mostLikely();
    const Point way = walkerOf(person, likely, scene.destinations).destination - person.position;
    const double length = std::min(2.2 * size, way.norm());
    if (length <= 0.0) continue;
    addLine(person.position, person.position + length * way.normalized(), colorOf(person.intention),
            ways);
  }
  Marker& rings = builder.beginList("attended", Marker::LINE_LIST, 0.2 * size, 0.07);
  for (const PersonBelief& person : scene.crowd.people) {
    const auto& ids = scene.attended;
    if (std::find(ids.begin(), ids.end(), person.id) == ids.end()) continue;
    addCircle(person.position, 0.9 * size, color(0.85, 0.10, 0.10), rings);
  }
  return builder.take();
}

MarkerArray treeMarkers(const TreeView& view, double symbol_size, const std_msgs::Header& header) {
  MarkerBuilder builder(header);
  const ValueRange range = valueRange(view);
  Marker& tree = builder.beginList("tree", Marker::LINE_LIST, 0.12 * symbol_size, 0.08);
  for (const TreeEdge& edge : view.edges) {
    const double fade = std::min(edge.depth - 1, kFadeDepth) / static_cast<double>(kFadeDepth);
    addLine(edge.from, edge.to, valueColor(range.share(edge.value), 1.0 - 0.7 * fade), tree);
  }
  Marker& rollouts = builder.beginList("rollouts", Marker::LINE_LIST, 0.15 * symbol_size, 0.07);
  for (const auto& path : view.rollouts) {
    addDashes(path, 1.2 * symbol_size, color(0.25, 0.25, 0.30, 0.7), rollouts);
  }
  return builder.take();
}

}  // namespace pomdp_crowd_nav
