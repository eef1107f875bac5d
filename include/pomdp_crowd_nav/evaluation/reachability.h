// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "pomdp_crowd_nav/planner/planner.h"
#include "pomdp_crowd_nav/world/static_map.h"

namespace pomdp_crowd_nav {

// Why the robot cannot stand at a goal; empty when it can.
std::string whyNotAPlace(const Point& goal, const StaticMap& map, const ModelParams& model);

// Where a trip begins and ends [m].
struct Way {
  Point from;
  Point goal;
};

// Why a path is no way to the goal: it leads through an obstacle or ends before the goal, as the
// path of a prior does that knows no better. Empty when it is one. A robot that the map has inside
// an obstacle may drive out of it.
std::string whyNoWay(const std::vector<Point>& path, const Point& goal, const StaticMap& map,
                     const ModelParams& model);

// The same of a planner's path from a place; empty where that path says nothing of obstacles.
std::string whyNoWay(const Planner& planner, const Way& way, const StaticMap& map,
                     const ModelParams& model);

}  // namespace pomdp_crowd_nav
