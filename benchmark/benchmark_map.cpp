// SPDX-License-Identifier: BSD-3-Clause
// How long the planner of a new map takes, and that of a new goal on the same map (Google
// Benchmark): an occupancy grid of 2000 x 2000 cells of 0.1 m, an office with walls, doors and
// pillars.
#include <benchmark/benchmark.h>

#include <cstdlib>
#include <string>

#include "pomdp_crowd_nav/planner/planner_factory.h"
#include "pomdp_crowd_nav/pomdp/upper_bound.h"
#include "pomdp_crowd_nav/prior/fast_marching_prior.h"

namespace pomdp_crowd_nav {
namespace {

constexpr int kSide = 2000;    // [cells]
constexpr double kCell = 0.1;  // [m]
constexpr int kRoom = 200;     // [cells], from wall to wall
constexpr int kDoor = 40;      // [cells]
constexpr double kMillimetre = 1e-3;

// A raster of square rooms, each with doors to its neighbours and a pillar.
OccupancyGrid office() {
  OccupancyGrid grid;
  grid.resolution = kCell;
  grid.columns = grid.rows = kSide;
  const auto is_wall = [](int across, int along) {
    const int from_middle = std::abs(along % kRoom - kRoom / 2);
    return across % kRoom < 2 && from_middle > kDoor / 2;
  };
  const auto is_pillar = [](int x, int y) {
    return std::abs(x % kRoom - kRoom / 4) < 5 && std::abs(y % kRoom - kRoom / 4) < 5;
  };
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      grid.blocked.push_back(is_wall(x, y) || is_wall(y, x) || is_pillar(x, y) ? 1 : 0);
    }
  }
  return grid;
}

StaticMap makeMap(const OccupancyGrid& grid) {
  StaticMap::Obstacles obstacles;
  obstacles.grid = grid;
  const Point corner = grid.origin + kCell * Point(grid.columns, grid.rows);
  return {Bounds{grid.origin, corner}, std::move(obstacles)};
}

// A MOVO's distances. Argument: cell of the prior [mm].
PlannerParams paramsFor(const benchmark::State& state) {
  PlannerParams params;
  params.model.vehicle.radius = 0.5;
  params.model.vehicle.max_speed = 1.0;
  params.model.obstacle_distance = 0.4;
  params.model.step = 0.5;
  params.prior.resolution = kMillimetre * static_cast<double>(state.range(0));
  params.prior.clearance = params.model.obstacleClearance();
  return params;
}

Task taskOn(const StaticMap& map, double goal) {
  return {map, Point(goal, goal), {Point(5.0, 5.0), Point(195.0, 195.0)}};
}

void distanceTransform(benchmark::State& state) {
  const OccupancyGrid grid = office();
  for (auto _ : state) benchmark::DoNotOptimize(makeMap(grid).hasObstacles());
}
BENCHMARK(distanceTransform)->Unit(benchmark::kMillisecond);

// The map's work and the goal's: what a changed map costs.
void newMap(benchmark::State& state, const std::string& planner) {
  const PlannerParams params = paramsFor(state);
  const OccupancyGrid grid = office();
  for (auto _ : state) {
    const StaticMap map = makeMap(grid);
    benchmark::DoNotOptimize(makePlanner(planner, taskOn(map, 187.0), params));
  }
}

#ifndef PCN_OLD
// The goal's work alone: what another goal on the same map costs.
void newGoal(benchmark::State& state, const std::string& planner) {
  const PlannerParams params = paramsFor(state);
  const StaticMap map = makeMap(office());
  Task task = taskOn(map, 187.0);
  task.clearances = clearancesOf(task, params.prior);
  makePlanner(planner, task, params);
  double goal = 187.0;
  for (auto _ : state) {
    task.goal.x() = goal = 200.0 - goal;
    benchmark::DoNotOptimize(makePlanner(planner, task, params));
  }
}

void sampleClearance(benchmark::State& state) {
  const PlannerParams params = paramsFor(state);
  const StaticMap map = makeMap(office());
  for (auto _ : state) {
    benchmark::DoNotOptimize(ClearanceGrid(map, params.prior.resolution).clearance);
  }
}
BENCHMARK(sampleClearance)->Arg(200)->Arg(100)->Unit(benchmark::kMillisecond);
#endif

void fastMarching(benchmark::State& state) {
  const PlannerParams params = paramsFor(state);
  const SpeedMap speeds = makeSpeedMap(makeMap(office()), params.prior);
  for (auto _ : state) benchmark::DoNotOptimize(ArrivalTimeField(speeds, {187.0, 187.0}).times());
}
BENCHMARK(fastMarching)->Arg(200)->Arg(100)->Unit(benchmark::kMillisecond);

void descent(benchmark::State& state) {
  const PlannerParams params = paramsFor(state);
  const SpeedMap speeds = makeSpeedMap(makeMap(office()), params.prior);
  const ArrivalTimeField field(speeds, {187.0, 187.0});
  for (auto _ : state) benchmark::DoNotOptimize(descentDirections(field, speeds).x);
}
BENCHMARK(descent)->Arg(200)->Arg(100)->Unit(benchmark::kMillisecond);

void table(benchmark::State& state) {
  const PlannerParams params = paramsFor(state);
  const StaticMap map = makeMap(office());
  const FastMarchingPrior prior(map, {187.0, 187.0}, params.prior);
  for (auto _ : state) {
    benchmark::DoNotOptimize(NavigationField(prior, map, params.prior.resolution).directions());
  }
}
BENCHMARK(table)->Arg(200)->Arg(100)->Unit(benchmark::kMillisecond);

void shortestWay(benchmark::State& state) {
  const PlannerParams params = paramsFor(state);
  const StaticMap map = makeMap(office());
  const ClearanceGrid clearances(map, params.prior.resolution);
  const Point goal(187.0, 187.0);
  for (auto _ : state) benchmark::DoNotOptimize(makeShortestWay(params.model, clearances, goal));
}
BENCHMARK(shortestWay)->Arg(200)->Arg(100)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace pomdp_crowd_nav

int main(int argc, char** argv) {
  using namespace pomdp_crowd_nav;
  for (const std::string planner : {"2d_fmm", "2d_prm", "1d_astar"}) {
    const auto add = [&](const std::string& what, auto run) {
      const std::string name = what + "/" + planner;
      benchmark::RegisterBenchmark(name.c_str(),
                                   [run, planner](benchmark::State& s) { run(s, planner); })
          ->Arg(200)
          ->Arg(100)
          ->Unit(benchmark::kMillisecond);
    };
    add("newMap", newMap);
#ifndef PCN_OLD
    add("newGoal", newGoal);
#endif
  }
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
