// SPDX-License-Identifier: BSD-3-Clause
#include "search_rig.h"

#include <cmath>
#include <random>

#include "pomdp_crowd_nav/planner/planner_factory.h"

namespace pomdp_crowd_nav {
namespace {

const Bounds kField{{0.0, 0.0}, {100.0, 100.0}};
const Point kStart(1.0, 25.0);
constexpr double kNearest = 3.0;    // [m]
constexpr double kFarthest = 15.0;  // [m]

// Uniform over the part of the ring about the start that is on the field.
Point placePerson(std::mt19937_64& random) {
  std::uniform_real_distribution<double> offset(-kFarthest, kFarthest);
  while (true) {
    const double dx = offset(random);
    const double dy = offset(random);
    const Point place = kStart + Point(dx, dy);
    const double distance = std::hypot(dx, dy);
    if (distance < kNearest || distance > kFarthest) continue;
    if (kField.contains(place)) return place;
  }
}

}  // namespace

StaticMap rigMap() { return StaticMap(kField, {}); }

Point rigGoal() { return {100.0, 75.0}; }

std::vector<Point> rigDestinations() {
  return {{0.0, 0.0}, {0.0, 100.0}, {100.0, 100.0}, {100.0, 0.0}};
}

PlannerParams rigPlannerParams(const SearchRigParams& params) {
  PlannerParams planner;
  planner.pedestrians = params.pedestrians;
  planner.model.horizon = params.depth * planner.model.step;
  planner.model.bold_rollouts = params.bold_rollouts;
  planner.model.bold_distance = 2.5;
  planner.model.upper_bound = params.upper_bound;
  planner.search.scenarios = params.scenarios;
  planner.search.threads = params.threads;
  return planner;
}

std::unique_ptr<Planner> makeRigPlanner(const SearchRigParams& params) {
  const StaticMap map = rigMap();
  return makePlanner("2d_fmm", {map, rigGoal(), rigDestinations()}, rigPlannerParams(params));
}

Situation rigSituation(int pedestrians, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  Situation situation;
  situation.vehicle = {kStart, 0.0, 0.0};
  for (int i = 0; i < pedestrians; ++i) {
    situation.crowd.people.push_back({i, placePerson(random), {0.0, 0.0}, 1.0, IntentionBelief(4)});
  }
  return situation;
}

}  // namespace pomdp_crowd_nav
