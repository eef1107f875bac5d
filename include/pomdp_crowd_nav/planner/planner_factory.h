// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "pomdp_crowd_nav/planner/navigation_tables.h"
#include "pomdp_crowd_nav/planner/planner.h"
#include "pomdp_crowd_nav/world/static_map.h"

namespace pomdp_crowd_nav {

// Where a planner drives, and where the people around it may be heading.
struct Task {
  const StaticMap& map;
  Point goal{0.0, 0.0};             // [m]
  std::vector<Point> destinations;  // [m], of people
  // Of all planners of this map and goal with these parameters; without it each makes its own.
  SharedTables* shared_tables = nullptr;
  // Of this map at the prior's resolution, for planners of all goals; without it each makes its
  // own.
  std::shared_ptr<const ClearanceGrid> clearances = nullptr;
};

// Those of the task, or else made anew.
std::shared_ptr<const ClearanceGrid> clearancesOf(const Task& task, const PriorParams& params);

// Names that makePlanner knows.
std::vector<std::string> plannerNames();

// Whether a planner is made for a kind of vehicle.
bool drives(const std::string& planner, VehicleKind kind);

// Throws std::invalid_argument unless it is, listing those that are, or where that vehicle turns
// too wide for the planner.
void requireDrives(const std::string& planner, const VehicleParams& vehicle);

// Throws std::invalid_argument for an unknown name (listing the known), a planner for another
// vehicle, a parameter out of range, and a goal that is off the map or inside an obstacle.
std::unique_ptr<Planner> makePlanner(const std::string& name, const Task& task,
                                     const PlannerParams& params);

}  // namespace pomdp_crowd_nav
