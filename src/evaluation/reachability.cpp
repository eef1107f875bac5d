// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/evaluation/reachability.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pomdp_crowd_nav {
namespace {

constexpr double kSpacing = 0.1;            // [m], of the places looked at along a path
constexpr double kTouch = 0.51 * kSpacing;  // [m], no wall fits between two places
constexpr double kSlack = 0.5;              // [m], beyond the goal tolerance, that a path may miss

bool isBlocked(const Point& from, const Point& to, const StaticMap& map) {
  const int pieces = std::max(1, static_cast<int>(std::ceil((to - from).norm() / kSpacing)));
  for (int i = 1; i <= pieces; ++i) {
    if (map.clearance(from + (to - from) * i / pieces) <= kTouch) return true;
  }
  return false;
}

}  // namespace

std::string whyNotAPlace(const Point& goal, const StaticMap& map, const ModelParams& model) {
  const std::string place = fmt::format("goal ({:.2f}, {:.2f})", goal.x(), goal.y());
  if (!map.bounds().contains(goal)) return place + " is off the map";
  const double clearance = map.clearance(goal);
  if (clearance <= 0.0) return place + " is inside an obstacle";
  // Within the tolerance there may be a place that is far enough from the obstacle.
  if (clearance + model.goal_tolerance >= model.obstacleClearance()) return "";
  return fmt::format("{} is too close to an obstacle: {:.2f} m, the robot keeps {:.2f} m", place,
                     clearance, model.obstacleClearance());
}

std::string whyNoWay(const std::vector<Point>& path, const Point& goal, const StaticMap& map,
                     const ModelParams& model) {
  const double slack = model.goal_tolerance + kSlack;
  const std::string no_way = fmt::format("no way to the goal ({:.2f}, {:.2f})", goal.x(), goal.y());
  size_t begin = 0;
  while (begin < path.size() && map.clearance(path[begin]) <= kTouch) ++begin;
  if (begin == path.size()) return no_way;
  for (size_t i = begin + 1; i < path.size(); ++i) {
    if (!isBlocked(path[i - 1], path[i], map)) continue;
    return no_way + fmt::format(": an obstacle at ({:.2f}, {:.2f})", path[i].x(), path[i].y());
  }
  if ((path.back() - goal).norm() <= slack) return "";
  return no_way +
         fmt::format(": known as far as ({:.2f}, {:.2f})", path.back().x(), path.back().y());
}

std::string whyNoWay(const Planner& planner, const Way& way, const StaticMap& map,
                     const ModelParams& model) {
  if (!planner.pathAvoidsObstacles()) return "";
  return whyNoWay(planner.globalPath(way.from), way.goal, map, model);
}

}  // namespace pomdp_crowd_nav
