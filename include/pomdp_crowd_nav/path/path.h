// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "pomdp_crowd_nav/world/vehicle.h"

namespace pomdp_crowd_nav {

// A way to drive, by arc length: straight and curved legs, each begins where the one before ends.
// Headings may jump between legs, where a holonomic base turns in place.
class Path {
 public:
  Path() = default;
  Path(const Point& start, std::vector<PathLeg> legs);

  bool isEmpty() const { return legs_.empty(); }
  double length() const { return begins_.empty() ? 0.0 : begins_.back(); }  // [m]
  const std::vector<PathLeg>& legs() const { return legs_; }

  // At `distance` [m] from the start; clamped to the path.
  Point positionAt(double distance) const;
  double headingAt(double distance) const;  // [rad], after a jump where there is one

  // The legs of the first `distance` metres, the last one cut off there.
  std::vector<PathLeg> firstLegs(double distance) const;

  // The path from `distance` [m] on.
  Path from(double distance) const;

  // Where on the first `within` metres the path is nearest to a place [m], to 1 cm.
  double nearestTo(const Point& place, double within) const;

 private:
  size_t legAt(double distance) const;

  std::vector<PathLeg> legs_;
  std::vector<Point> starts_;   // of the legs, then the end
  std::vector<double> begins_;  // [m], arc length at which the legs begin, then the length
};

}  // namespace pomdp_crowd_nav
