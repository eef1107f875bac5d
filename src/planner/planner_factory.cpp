// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/planner/planner_factory.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "pomdp_crowd_nav/params/closest_name.h"
#include "pomdp_crowd_nav/planner/extended_space_planner.h"
#include "pomdp_crowd_nav/planner/limited_space_planner.h"
#include "pomdp_crowd_nav/prior/look_ahead_prior.h"

namespace pomdp_crowd_nav {
namespace {

using Maker = std::unique_ptr<Planner> (*)(const Task&, const PlannerParams&);

using PriorPointer = std::shared_ptr<const RolloutPrior>;

// The paper's planner ES along a prior. Planners of one task share the tables of one prior.
std::unique_ptr<Planner> makeExtendedSpace(const char* prior, const Task& task,
                                           const PlannerParams& params, bool looks_ahead = false) {
  PriorParams prior_params = params.prior;
  prior_params.clearance = params.model.obstacleClearance();
  prior_params.robot_radius = params.model.vehicle.radius;
  const auto make = [&] {
    const auto clearances = clearancesOf(task, prior_params);
    const auto make_prior = [&]() -> PriorPointer {
      PriorPointer path = makePrior(prior, *clearances, task.goal, prior_params);
      if (!looks_ahead) return path;
      return std::make_shared<LookAheadPrior>(std::move(path), prior_params.look_ahead);
    };
    return std::make_shared<const NavigationTables>(make_prior, *clearances, task.goal,
                                                    params.model);
  };
  return std::make_unique<ExtendedSpacePlanner>(
      task, task.shared_tables ? task.shared_tables->of(prior, make) : make(), params);
}

template <class SomePlanner>
std::unique_ptr<Planner> make(const Task& task, const PlannerParams& params) {
  return std::make_unique<SomePlanner>(task, params);
}

constexpr const char* kLimitedSpace = "1d_astar";

enum class Drives { kHolonomic, kCar, kBoth };

struct Entry {
  const char* name;
  Drives vehicles;
  Maker make;
};

const char* nameOf(VehicleKind kind) { return kind == VehicleKind::kCar ? "car" : "holonomic"; }

// A new planner is one more entry here and its name in config/parameters.yaml.
const Entry kPlanners[] = {
    {"2d_fmm", Drives::kHolonomic,
     [](const Task& task, const PlannerParams& params) {
       return makeExtendedSpace("fast_marching", task, params);
     }},
    {"2d_prm", Drives::kHolonomic,
     [](const Task& task, const PlannerParams& params) {
       return makeExtendedSpace("roadmap", task, params);
     }},
    {"2d_straight", Drives::kHolonomic,
     [](const Task& task, const PlannerParams& params) {
       return makeExtendedSpace("straight_line", task, params);
     }},
    {"2d_nhv", Drives::kCar,
     [](const Task& task, const PlannerParams& params) {
       return makeExtendedSpace("straight_line", task, params);
     }},
    {"2d_nhv_fm2", Drives::kCar,
     [](const Task& task, const PlannerParams& params) {
       constexpr bool kLooksAhead = true;  // a car steers toward where the path leads
       return makeExtendedSpace("fast_marching_square", task, params, kLooksAhead);
     }},
    {kLimitedSpace, Drives::kBoth, make<LimitedSpacePlanner>},
};

}  // namespace

std::shared_ptr<const ClearanceGrid> clearancesOf(const Task& task, const PriorParams& params) {
  if (task.clearances) return task.clearances;
  if (!(params.resolution > 0.0)) {
    throw std::invalid_argument(
        fmt::format("prior.resolution must be positive, got {}", params.resolution));
  }
  return std::make_shared<const ClearanceGrid>(task.map, params.resolution);
}

std::vector<std::string> plannerNames() {
  std::vector<std::string> names;
  for (const Entry& entry : kPlanners) names.emplace_back(entry.name);
  return names;
}

bool drives(const std::string& planner, VehicleKind kind) {
  for (const Entry& entry : kPlanners) {
    if (planner != entry.name) continue;
    const Drives alone = kind == VehicleKind::kCar ? Drives::kCar : Drives::kHolonomic;
    return entry.vehicles == Drives::kBoth || entry.vehicles == alone;
  }
  return false;
}

void requireDrives(const std::string& planner, const VehicleParams& vehicle) {
  const VehicleKind kind = vehicle.kind;
  if (drives(planner, kind)) {
    if (planner == kLimitedSpace) LimitedSpacePlanner::requireDrivable(vehicle);
    return;
  }
  std::vector<std::string> able;
  for (const std::string& name : plannerNames()) {
    if (drives(name, kind)) able.push_back(name);
  }
  throw std::invalid_argument(fmt::format("planner must be one of {} for vehicle '{}', got '{}'",
                                          commaSeparated(able), nameOf(kind), planner));
}

std::unique_ptr<Planner> makePlanner(const std::string& name, const Task& task,
                                     const PlannerParams& params) {
  validate(params);
  if (task.destinations.empty()) {
    throw std::invalid_argument("destinations must name at least one place that people walk to");
  }
  for (const Entry& entry : kPlanners) {
    if (name != entry.name) continue;
    requireDrives(name, params.model.vehicle);
    return entry.make(task, params);
  }
  const std::vector<std::string> known = plannerNames();
  throw std::invalid_argument(fmt::format("planner must be one of {}, got '{}'{}",
                                          commaSeparated(known), name, didYouMean(name, known)));
}

}  // namespace pomdp_crowd_nav
