// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/ros/marker_shapes.h"

#include <algorithm>
#include <cmath>

#include "pomdp_crowd_nav/ros/conversions.h"
#include "pomdp_crowd_nav/ros/markers.h"

namespace pomdp_crowd_nav {
namespace {

constexpr int kCircleSides = 24;
constexpr double kTextHeight = 3.0;  // [m], above everything that is drawn

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
    const bool is_empty = marker.points.empty() && marker.text.empty();
    if (marker.action == Marker::ADD && is_empty) marker.action = Marker::DELETE;
  }
  return std::move(array_);
}

visualization_msgs::Marker& MarkerBuilder::add(const std::string& name, int type) {
  visualization_msgs::Marker marker;
  marker.header = header_;
  marker.ns = name;
  marker.type = type;
  marker.pose.orientation.w = 1.0;
  marker.color = color(1.0, 1.0, 1.0);
  array_.markers.push_back(marker);
  return array_.markers.back();
}

visualization_msgs::Marker& MarkerBuilder::beginList(const std::string& name, int type,
                                                     double scale, double z) {
  visualization_msgs::Marker& list = add(name, type);
  const bool is_surface = type == visualization_msgs::Marker::TRIANGLE_LIST;
  list.pose.position.z = z;
  list.scale.x = list.scale.y = list.scale.z = is_surface ? 1.0 : scale;
  return list;
}

visualization_msgs::Marker& MarkerBuilder::addText(const std::string& name, const std::string& text,
                                                   double height, const Point& center) {
  visualization_msgs::Marker& words = add(name, visualization_msgs::Marker::TEXT_VIEW_FACING);
  words.text = text;
  words.scale.x = words.scale.y = words.scale.z = height;
  words.pose.position = toMessage(center, kTextHeight);
  words.color = color(0.10, 0.12, 0.15);
  return words;
}

std_msgs::ColorRGBA paled(const std_msgs::ColorRGBA& ink, double share) {
  const auto mix = [&](double tone) { return share * tone + (1.0 - share) * 0.97; };
  return color(mix(ink.r), mix(ink.g), mix(ink.b));
}

void fixTo(const std::string& frame, visualization_msgs::Marker& list) {
  list.header.frame_id = frame;
  list.header.stamp = ros::Time();
  list.frame_locked = true;
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

void addStroke(const Stroke& stroke, const std_msgs::ColorRGBA& color,
               visualization_msgs::Marker& triangles) {
  const Point along = stroke.to - stroke.from;
  const double length = along.norm();
  if (!along.allFinite() || !(length > 0.0) || !hasRoom(triangles, 6)) return;
  const Point side = 0.5 * stroke.width / length * Point(-along.y(), along.x());
  for (const Point& corner :
       {Point(stroke.from + side), Point(stroke.from - side), Point(stroke.to - side),
        Point(stroke.to - side), Point(stroke.to + side), Point(stroke.from + side)}) {
    add(corner, color, triangles);
  }
}

void addArrow(const Stroke& shaft, const std_msgs::ColorRGBA& color,
              visualization_msgs::Marker& triangles) {
  constexpr double kHeadWidth = 2.6, kHeadLength = 2.4;  // in widths of the shaft
  const Point along = shaft.to - shaft.from;
  const double length = along.norm();
  if (!along.allFinite() || !(length > 0.0) || !hasRoom(triangles, 9)) return;
  const double head = std::min(kHeadLength * shaft.width, 0.6 * length);
  const Point neck = shaft.to - head / length * along;
  const Point side = 0.5 * kHeadWidth * shaft.width / length * Point(-along.y(), along.x());
  addStroke({shaft.from, neck, shaft.width}, color, triangles);
  add(neck + side, color, triangles);
  add(neck - side, color, triangles);
  add(shaft.to, color, triangles);
}

}  // namespace pomdp_crowd_nav
