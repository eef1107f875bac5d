// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

namespace pomdp_crowd_nav {

using Point = Eigen::Vector2d;  // [m], planning frame

struct Pose {
  Point position{0.0, 0.0};  // [m]
  double heading = 0.0;      // [rad], counter-clockwise from x
};

// Angle in (-pi, pi] that points the same way as `angle` [rad].
double wrapAngle(double angle);

Point unitVector(double angle);

// Direction from one point to another [rad]; 0 when they coincide.
double bearing(const Point& from, const Point& to);

double distanceToSegment(const Point& point, const Point& a, const Point& b);

// True on the inside of the closed polygon (even-odd rule).
bool isInsidePolygon(const Point& point, const std::vector<Point>& vertices);

}  // namespace pomdp_crowd_nav
