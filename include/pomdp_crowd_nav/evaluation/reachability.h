// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "pomdp_crowd_nav/params/load_params.h"
#include "pomdp_crowd_nav/world/static_map.h"

namespace pomdp_crowd_nav {

// Why the robot cannot stand at a goal; empty when it can.
std::string whyNotAPlace(const Point& goal, const StaticMap& map, const ModelParams& model);

// Why a global path is no way to the goal: it leads through an obstacle or ends before the goal, as
// the path of a prior does that knows no better. Empty when it is one, and for a planner whose path
// says nothing of obstacles. A robot that the map has inside an obstacle may drive out of it.
std::string whyNoWay(const std::vector<Point>& path, const Point& goal, const StaticMap& map,
                     const NavigationParams& params);

}  // namespace pomdp_crowd_nav
