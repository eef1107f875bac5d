// SPDX-License-Identifier: BSD-3-Clause
// Path searches of 1d_astar across the paper's fields (Google Benchmark). Items are expansions.
#include <benchmark/benchmark.h>

#include <cmath>
#include <random>

#include "pomdp_crowd_nav/path/hybrid_astar.h"
#include "pomdp_crowd_nav/prior/prior_factory.h"

namespace pomdp_crowd_nav {
namespace {

const Point kGoal(100.0, 75.0);
const Pose kStart{{1.0, 25.0}, 0.0};
const std::vector<Point> kCorners{{0.0, 0.0}, {0.0, 100.0}, {100.0, 100.0}, {100.0, 0.0}};

// The open field, the six small obstacles, and the large one.
StaticMap mapOf(int scenario) {
  StaticMap::Obstacles obstacles;
  if (scenario == 2) {
    obstacles.circles = {{{50.0, 70.0}, 5.0}, {{25.0, 70.0}, 5.0}, {{50.0, 50.0}, 5.0},
                         {{30.0, 20.0}, 5.0}, {{70.0, 20.0}, 5.0}, {{80.0, 50.0}, 5.0}};
  }
  if (scenario == 3) obstacles.circles = {{{65.0, 35.0}, 35.0}};
  return StaticMap({{0.0, 0.0}, {100.0, 100.0}}, obstacles);
}

// 3 m to 15 m from the start, every other one surely heading somewhere.
std::vector<PersonBelief> peopleAhead(std::mt19937& random) {
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  std::vector<PersonBelief> people;
  for (int i = 0; i < 6; ++i) {
    const Point place = kStart.position +
                        (3.0 + 12.0 * unit(random)) * unitVector(1.4 * (2.0 * unit(random) - 1.0));
    PersonBelief person{i, place, {0.0, 0.0}, 1.0, IntentionBelief(4)};
    const Point before = place - 0.5 * unitVector(2.0 * M_PI * unit(random));
    for (int k = 0; i % 2 == 0 && k < 8; ++k) person.intention.update(before, place, kCorners);
    people.push_back(person);
  }
  return people;
}

void findPath(benchmark::State& state, VehicleKind kind) {
  const StaticMap map = mapOf(static_cast<int>(state.range(0)));
  PriorParams prior;
  prior.extra_clearance = 0.0;
  const char* name = map.hasObstacles() ? "fast_marching" : "straight_line";
  const NavigationField field(*makePrior(name, map, kGoal, prior), map, prior.resolution);
  HybridAstar::Params params;
  params.vehicle = kind;
  params.crowd.pace = 2.0;
  HybridAstar search(map, field, params);
  std::mt19937 random(1);
  std::vector<std::vector<PersonBelief>> crowds;
  for (int i = 0; i < 64; ++i) crowds.push_back(peopleAhead(random));
  HybridAstar::Limit limit;
  limit.max_expansions = 75000;
  long expansions = 0;
  long found = 0;
  size_t i = 0;
  for (auto _ : state) {
    const HybridAstar::Result result =
        search.find(kStart, crowds[i++ % crowds.size()], kCorners, limit);
    expansions += result.expansions;
    if (result.outcome == HybridAstar::Outcome::kFound) ++found;
  }
  state.SetItemsProcessed(expansions);
  const auto searches = static_cast<double>(state.iterations());
  state.counters["expansions"] = static_cast<double>(expansions) / searches;
  state.counters["found"] = static_cast<double>(found) / searches;
}

// Argument: the paper's scenario.
void holonomic(benchmark::State& state) { findPath(state, VehicleKind::kHolonomic); }
void car(benchmark::State& state) { findPath(state, VehicleKind::kCar); }
BENCHMARK(holonomic)->DenseRange(1, 3)->Unit(benchmark::kMillisecond);
BENCHMARK(car)->DenseRange(1, 3)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace pomdp_crowd_nav

BENCHMARK_MAIN();
