// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/prior/prior_factory.h"

#include <fmt/format.h>

#include <stdexcept>

#include "pomdp_crowd_nav/params/closest_name.h"
#include "pomdp_crowd_nav/prior/fast_marching_prior.h"
#include "pomdp_crowd_nav/prior/fast_marching_square_prior.h"
#include "pomdp_crowd_nav/prior/roadmap_prior.h"
#include "pomdp_crowd_nav/prior/straight_line_prior.h"

namespace pomdp_crowd_nav {
namespace {

using PriorPtr = std::shared_ptr<const RolloutPrior>;

// A map, sampled when it is asked for unless somebody has done that before.
struct Source {
  const StaticMap& map;
  const ClearanceGrid* sampled = nullptr;
};

PriorPtr makeFastMarching(const Source& source, const Point& goal, const PriorParams& params) {
  if (source.sampled == nullptr) {
    return std::make_shared<FastMarchingPrior>(source.map, goal, params);
  }
  return std::make_shared<FastMarchingPrior>(makeSpeedMap(*source.sampled, params), goal);
}

PriorPtr makeSquare(const Source& source, const Point& goal, const PriorParams& params) {
  if (source.sampled == nullptr) {
    return makeFastMarchingSquare(ClearanceGrid(source.map, params.resolution), goal, params);
  }
  return makeFastMarchingSquare(*source.sampled, goal, params);
}

PriorPtr makeRoadmap(const Source& source, const Point& goal, const PriorParams& params) {
  return std::make_shared<RoadmapPrior>(source.map, goal, params);
}

PriorPtr makeStraightLine(const Source&, const Point& goal, const PriorParams&) {
  return std::make_shared<StraightLinePrior>(goal);
}

struct Entry {
  const char* name;
  PriorPtr (*make)(const Source& source, const Point& goal, const PriorParams& params);
};

// A new prior is one more line here.
constexpr Entry kPriors[] = {
    {"fast_marching", makeFastMarching},
    {"fast_marching_square", makeSquare},
    {"roadmap", makeRoadmap},
    {"straight_line", makeStraightLine},
};

void requireFreeGoal(const StaticMap& map, const Point& goal) {
  if (!map.bounds().contains(goal)) {
    throw std::invalid_argument(fmt::format("goal ({}, {}) is off the map", goal.x(), goal.y()));
  }
  if (map.clearance(goal) > 0.0) return;
  throw std::invalid_argument(
      fmt::format("goal ({}, {}) is inside an obstacle", goal.x(), goal.y()));
}

PriorPtr makeNamed(const std::string& name, const Source& source, const Point& goal,
                   const PriorParams& params) {
  for (const Entry& entry : kPriors) {
    if (name != entry.name) continue;
    requireFreeGoal(source.map, goal);
    return entry.make(source, goal, params);
  }
  const std::vector<std::string> known = priorNames();
  throw std::invalid_argument(fmt::format("prior must be one of {}, got '{}'{}",
                                          commaSeparated(known), name, didYouMean(name, known)));
}

}  // namespace

std::vector<std::string> priorNames() {
  std::vector<std::string> names;
  for (const Entry& entry : kPriors) names.emplace_back(entry.name);
  return names;
}

std::shared_ptr<const RolloutPrior> makePrior(const std::string& name, const StaticMap& map,
                                              const Point& goal, const PriorParams& params) {
  return makeNamed(name, {map}, goal, params);
}

std::shared_ptr<const RolloutPrior> makePrior(const std::string& name,
                                              const ClearanceGrid& clearances, const Point& goal,
                                              const PriorParams& params) {
  return makeNamed(name, {clearances.map, &clearances}, goal, params);
}

}  // namespace pomdp_crowd_nav
