// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/world/geometry.h"

#include <algorithm>
#include <cmath>

namespace pomdp_crowd_nav {

double wrapAngle(double angle) {
  const double wrapped = std::remainder(angle, 2.0 * M_PI);
  return wrapped <= -M_PI ? M_PI : wrapped;
}

Point unitVector(double angle) { return {std::cos(angle), std::sin(angle)}; }

double bearing(const Point& from, const Point& to) {
  return std::atan2(to.y() - from.y(), to.x() - from.x());
}

double distanceToSegment(const Point& point, const Point& a, const Point& b) {
  const Point along = b - a;
  const double length_squared = along.squaredNorm();
  if (length_squared == 0.0) return (point - a).norm();
  const double share = std::clamp((point - a).dot(along) / length_squared, 0.0, 1.0);
  return (point - (a + share * along)).norm();
}

bool isInsidePolygon(const Point& point, const std::vector<Point>& vertices) {
  bool inside = false;
  for (size_t i = 0, j = vertices.size() - 1; i < vertices.size(); j = i++) {
    const Point& a = vertices[i];
    const Point& b = vertices[j];
    if ((a.y() > point.y()) == (b.y() > point.y())) continue;
    const double x = a.x() + (point.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x());
    if (point.x() < x) inside = !inside;
  }
  return inside;
}

}  // namespace pomdp_crowd_nav
