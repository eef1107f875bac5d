// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/planner/planner_factory.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "pomdp_crowd_nav/planner/extended_space_planner.h"
#include "pomdp_crowd_nav/prior/look_ahead_prior.h"

namespace pomdp_crowd_nav {
namespace {

using Maker = std::unique_ptr<Planner> (*)(const Task&, const PlannerParams&);

// The paper's planner ES with the prior `name`, kept clear of obstacles as the model asks.
std::unique_ptr<Planner> makeExtendedSpace(const char* prior, const Task& task,
                                           const PlannerParams& params) {
  PriorParams prior_params = params.prior;
  prior_params.clearance = params.model.obstacleClearance();
  return std::make_unique<ExtendedSpacePlanner>(
      task, makePrior(prior, task.map, task.goal, prior_params), params);
}

// For a car: the direction is that of the path a little ahead.
std::unique_ptr<Planner> makeSteered(const char* prior, const Task& task,
                                     const PlannerParams& params) {
  PriorParams prior_params = params.prior;
  prior_params.clearance = params.model.obstacleClearance();
  auto path = makePrior(prior, task.map, task.goal, prior_params);
  return std::make_unique<ExtendedSpacePlanner>(
      task, std::make_shared<LookAheadPrior>(std::move(path), prior_params.look_ahead), params);
}

struct Entry {
  const char* name;
  VehicleKind vehicle;
  Maker make;
};

const char* nameOf(VehicleKind kind) { return kind == VehicleKind::kCar ? "car" : "holonomic"; }

const Entry kPlanners[] = {
    {"2d_fmm", VehicleKind::kHolonomic,
     [](const Task& task, const PlannerParams& params) {
       return makeExtendedSpace("fast_marching", task, params);
     }},
    {"2d_prm", VehicleKind::kHolonomic,
     [](const Task& task, const PlannerParams& params) {
       return makeExtendedSpace("roadmap", task, params);
     }},
    {"2d_straight", VehicleKind::kHolonomic,
     [](const Task& task, const PlannerParams& params) {
       return makeExtendedSpace("straight_line", task, params);
     }},
    {"2d_nhv", VehicleKind::kCar,
     [](const Task& task, const PlannerParams& params) {
       return makeExtendedSpace("straight_line", task, params);
     }},
    {"2d_nhv_fm2", VehicleKind::kCar,
     [](const Task& task, const PlannerParams& params) {
       return makeSteered("fast_marching_square", task, params);
     }},
};

}  // namespace

std::vector<std::string> plannerNames() {
  std::vector<std::string> names;
  for (const Entry& entry : kPlanners) names.emplace_back(entry.name);
  return names;
}

bool drives(const std::string& planner, VehicleKind kind) {
  for (const Entry& entry : kPlanners) {
    if (planner == entry.name) return entry.vehicle == kind;
  }
  return false;
}

void requireDrives(const std::string& planner, VehicleKind kind) {
  if (drives(planner, kind)) return;
  std::string able;
  for (const std::string& name : plannerNames()) {
    if (drives(name, kind)) able += (able.empty() ? "" : ", ") + name;
  }
  throw std::invalid_argument(fmt::format("planner must be one of {} for vehicle '{}', got '{}'",
                                          able, nameOf(kind), planner));
}

std::unique_ptr<Planner> makePlanner(const std::string& name, const Task& task,
                                     const PlannerParams& params) {
  validate(params);
  if (task.destinations.empty()) {
    throw std::invalid_argument("destinations must name at least one place that people walk to");
  }
  for (const Entry& entry : kPlanners) {
    if (name != entry.name) continue;
    requireDrives(name, params.model.vehicle.kind);
    return entry.make(task, params);
  }
  std::string known;
  for (const Entry& entry : kPlanners)
    known += (known.empty() ? "" : ", ") + std::string(entry.name);
  throw std::invalid_argument(fmt::format("planner must be one of {}, got '{}'", known, name));
}

}  // namespace pomdp_crowd_nav
