// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/control/obstacle_reflex.h"

#include <algorithm>
#include <cmath>

namespace pomdp_crowd_nav {
namespace {

constexpr double kSpacing = 0.05;  // [m], of the places that are looked at
constexpr double kMargin = 0.05;   // [m], kept beyond the robot's radius
constexpr int kMoments = 20;       // of a motion

}  // namespace

bool ObstacleReflex::mustBrake(const VehicleState& state, const StaticMap& map) const {
  std::vector<Point> way{state.position};
  addBraking(state, way);
  return touches(way, map);
}

bool ObstacleReflex::hits(const StepMotion& motion, const StaticMap& map) const {
  std::vector<Point> way;
  for (int i = 0; i <= kMoments; ++i) {
    way.push_back(motion.positionAt(motion.duration * i / kMoments));
  }
  addBraking(motion.end(), way);
  return touches(way, map);
}

// A way that begins in touch must lead away, and one that begins inside must lead out.
bool ObstacleReflex::touches(const std::vector<Point>& way, const StaticMap& map) const {
  const double begin = map.clearance(way.front());
  if (begin <= 0.0 && !leadsOut(way, map)) return true;
  const double least = std::min(vehicle_.radius + kMargin, begin - 0.5 * kMargin);
  return std::any_of(way.begin(), way.end(),
                     [&](const Point& place) { return map.clearance(place) < least; });
}

// Inside an obstacle of a grid every place is as bad as any other: what counts is what the robot's
// front reaches. To stand is allowed.
bool ObstacleReflex::leadsOut(const std::vector<Point>& way, const StaticMap& map) const {
  const Point course = way.back() - way.front();
  const double length = course.norm();
  if (length <= 0.0) return true;
  const Point front = way.back() + (vehicle_.radius + kMargin) / length * course;
  return map.clearance(front) > map.clearance(way.front());
}

void ObstacleReflex::addBraking(const VehicleState& from, std::vector<Point>& way) const {
  const double length = reaction_time_ * from.speed + stoppingDistance(vehicle_, from.speed);
  const int count = static_cast<int>(std::ceil(length / kSpacing));
  for (int i = 1; i <= count; ++i) {
    way.push_back(from.position + length * i / count * unitVector(from.heading));
  }
}

}  // namespace pomdp_crowd_nav
