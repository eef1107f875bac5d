// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <visualization_msgs/MarkerArray.h>

#include <string>
#include <vector>

#include "pomdp_crowd_nav/world/geometry.h"

namespace pomdp_crowd_nav {

// Builds an array of list markers; see markers.h for what holds of each.
class MarkerBuilder {
 public:
  explicit MarkerBuilder(const std_msgs::Header& header);

  // A list of `type` (visualization_msgs::Marker), `scale` [m], at height `z` [m]. The reference
  // holds until the next list is begun.
  visualization_msgs::Marker& beginList(const std::string& name, int type, double scale, double z);

  visualization_msgs::MarkerArray take();

 private:
  std_msgs::Header header_;
  visualization_msgs::MarkerArray array_;
};

std_msgs::ColorRGBA color(double red, double green, double blue, double alpha = 1.0);

// Each adds to a list as long as it fits; the height is the list's own.
void addPoint(const Point& point, const std_msgs::ColorRGBA& color,
              visualization_msgs::Marker& list);
void addLine(const Point& from, const Point& to, const std_msgs::ColorRGBA& color,
             visualization_msgs::Marker& lines);
void addCircle(const Point& center, double radius, const std_msgs::ColorRGBA& color,
               visualization_msgs::Marker& lines);
void addDisc(const Point& center, double radius, const std_msgs::ColorRGBA& color,
             visualization_msgs::Marker& triangles);
void addDashes(const std::vector<Point>& path, double dash, const std_msgs::ColorRGBA& color,
               visualization_msgs::Marker& lines);

}  // namespace pomdp_crowd_nav
