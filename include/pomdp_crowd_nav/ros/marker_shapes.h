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
  // holds until the next list or text is begun.
  visualization_msgs::Marker& beginList(const std::string& name, int type, double scale, double z);

  // Words centred on a place, letters of `height` [m]; no marker where there are none.
  visualization_msgs::Marker& addText(const std::string& name, const std::string& text,
                                      double height, const Point& center);

  visualization_msgs::MarkerArray take();

 private:
  visualization_msgs::Marker& add(const std::string& name, int type);

  std_msgs::Header header_;
  visualization_msgs::MarkerArray array_;
};

std_msgs::ColorRGBA color(double red, double green, double blue, double alpha = 1.0);

// The colour as it would look with an alpha of `share` on white paper. RViz draws no lines that can
// be seen through.
std_msgs::ColorRGBA paled(const std_msgs::ColorRGBA& color, double share);

// Moves the list to a frame in which it stays put; RViz moves it with the frame.
void fixTo(const std::string& frame, visualization_msgs::Marker& list);

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

// A line as a surface, so that each may have a width [m] of its own.
struct Stroke {
  Point from{0.0, 0.0};
  Point to{0.0, 0.0};
  double width = 0.1;
};
void addStroke(const Stroke& stroke, const std_msgs::ColorRGBA& color,
               visualization_msgs::Marker& triangles);
// The same with a head in proportion to the width, at the end of the stroke.
void addArrow(const Stroke& shaft, const std_msgs::ColorRGBA& color,
              visualization_msgs::Marker& triangles);

}  // namespace pomdp_crowd_nav
