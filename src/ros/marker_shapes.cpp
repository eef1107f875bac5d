// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/ros/marker_shapes.h"

#include <algorithm>
#include <cmath>

#include "pomdp_crowd_nav/ros/conversions.h"
#include "pomdp_crowd_nav/ros/markers.h"

namespace pomdp_crowd_nav {
namespace {

constexpr int kCircleSides = 24;

bool hasRoom(const visualization_msgs::Marker& list, size_t points) {
  return list.points.size() + points < kMaxPoints;
}

void add(const Point& point, const std_msgs::ColorRGBA& color, visualization_msgs::Marker& list) {
  list.points.push_back(toMessage(point));
  list.colors.push_back(color);
}

Point onCircle(const Point& center, double radius, int side) {
  return center + radius * unitVector(2.0 * M_PI * side / kCircleSides);
}

}  // namespace

MarkerBuilder::MarkerBuilder(const std_msgs::Header& header) : header_(header) {
  visualization_msgs::Marker clear;
  clear.header = header;
  clear.action = visualization_msgs::Marker::DELETEALL;
  clear.pose.orientation.w = 1.0;
  array_.markers.push_back(clear);
}

// RViz calls an empty list an error; to delete one is none.
visualization_msgs::MarkerArray MarkerBuilder::take() {
  using visualization_msgs::Marker;
  for (Marker& marker : array_.markers) {
    if (marker.action == Marker::ADD && marker.points.empty()) marker.action = Marker::DELETE;
  }
  return std::move(array_);
}

visualization_msgs::Marker& MarkerBuilder::beginList(const std::string& name, int type,
                                                     double scale, double z) {
  visualization_msgs::Marker list;
  list.header = header_;
  list.ns = name;
  list.type = type;
  list.pose.orientation.w = 1.0;
  list.pose.position.z = z;
  list.scale.x = list.scale.y = list.scale.z = scale;
  if (type == visualization_msgs::Marker::TRIANGLE_LIST) {
    list.scale.x = list.scale.y = list.scale.z = 1.0;
  }
  list.color = color(1.0, 1.0, 1.0);
  array_.markers.push_back(list);
  return array_.markers.back();
}

std_msgs::ColorRGBA color(double red, double green, double blue, double alpha) {
  std_msgs::ColorRGBA message;
  message.r = static_cast<float>(red);
  message.g = static_cast<float>(green);
  message.b = static_cast<float>(blue);
  message.a = static_cast<float>(alpha);
  return message;
}

void addPoint(const Point& point, const std_msgs::ColorRGBA& color,
              visualization_msgs::Marker& list) {
  if (point.allFinite() && hasRoom(list, 1)) add(point, color, list);
}

void addLine(const Point& from, const Point& to, const std_msgs::ColorRGBA& color,
             visualization_msgs::Marker& lines) {
  if (!from.allFinite() || !to.allFinite() || !hasRoom(lines, 2)) return;
  add(from, color, lines);
  add(to, color, lines);
}

void addCircle(const Point& center, double radius, const std_msgs::ColorRGBA& color,
               visualization_msgs::Marker& lines) {
  for (int side = 0; side < kCircleSides; ++side) {
    addLine(onCircle(center, radius, side), onCircle(center, radius, side + 1), color, lines);
  }
}

void addDisc(const Point& center, double radius, const std_msgs::ColorRGBA& color,
             visualization_msgs::Marker& triangles) {
  if (!center.allFinite() || !hasRoom(triangles, 3 * kCircleSides)) return;
  for (int side = 0; side < kCircleSides; ++side) {
    add(center, color, triangles);
    add(onCircle(center, radius, side), color, triangles);
    add(onCircle(center, radius, side + 1), color, triangles);
  }
}

void addDashes(const std::vector<Point>& path, double dash, const std_msgs::ColorRGBA& color,
               visualization_msgs::Marker& lines) {
  double travelled = 0.0;  // [m], dashes lie where floor(travelled / dash) is even
  for (size_t i = 1; i < path.size(); ++i) {
    const double length = (path[i] - path[i - 1]).norm();
    if (!(length > 0.0) || !std::isfinite(length)) continue;
    const Point direction = (path[i] - path[i - 1]) / length;
    for (double at = 0.0; at < length;) {
      const double index = std::floor((travelled + at) / dash + 1e-9);
      const double until = std::min(length, (index + 1.0) * dash - travelled);
      const bool visible = static_cast<long>(index) % 2 == 0;
      if (visible)
        addLine(path[i - 1] + at * direction, path[i - 1] + until * direction, color, lines);
      at = std::max(until, at + 1e-6);
    }
    travelled += length;
  }
}

}  // namespace pomdp_crowd_nav
