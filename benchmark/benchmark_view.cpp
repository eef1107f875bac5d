// SPDX-License-Identifier: BSD-3-Clause
// What each picture for RViz costs (Google Benchmark): a tree of half a second's search, 400
// people, the arrival times of fields of 100 m to 500 m, a roadmap. Only `viewTree` runs in the
// planning thread; see doc/view.md.
#include <benchmark/benchmark.h>

#include "pomdp_crowd_nav/planner/planner_factory.h"
#include "pomdp_crowd_nav/ros/belief_markers.h"
#include "pomdp_crowd_nav/ros/markers.h"
#include "pomdp_crowd_nav/ros/prior_layers.h"

namespace pomdp_crowd_nav {
namespace {

constexpr int kMaxEdges = 4000;  // as NavigationDisplay
const std::vector<Point> kCorners = {Point(0.0, 0.0), Point(100.0, 0.0), Point(100.0, 100.0),
                                     Point(0.0, 100.0)};

StaticMap field(double side) { return {Bounds{Point(0.0, 0.0), Point(side, side)}, {}}; }

CrowdBelief people(int count) {
  CrowdBelief crowd;
  for (int i = 0; i < count; ++i) {
    const Point place(5.0 + 0.9 * (i % 100), 5.0 + 20.0 * (i / 100));
    crowd.people.push_back({i, place, Point(1.0, 0.0), 1.0, IntentionBelief(kCorners.size())});
  }
  return crowd;
}

std::unique_ptr<Planner> plannerOn(const StaticMap& map, const std::string& name) {
  PlannerParams params;
  params.model.step = 0.5;
  params.prior.clearance = params.model.obstacleClearance();
  return makePlanner(name, {map, 0.9 * map.bounds().max, kCorners}, params);
}

// Argument: depth, in steps.
void viewTree(benchmark::State& state) {
  const StaticMap map = field(100.0);
  const auto planner = plannerOn(map, "2d_fmm");
  const auto now = SearchLimit::Clock::now();
  planner->decide({VehicleState{Point(50.0, 35.0), 0.5, 1.0}, people(400)},
                  SearchLimit::until(now + std::chrono::milliseconds(500)));
  const int depth = static_cast<int>(state.range(0));
  for (auto _ : state) benchmark::DoNotOptimize(planner->viewTree({kMaxEdges, depth}));
  state.counters["edges"] = static_cast<double>(planner->viewTree({1 << 30, 1 << 30}).edges.size());
}
BENCHMARK(viewTree)->Arg(6)->Arg(200)->Unit(benchmark::kMillisecond);

void drawTree(benchmark::State& state) {
  TreeScene scene;
  for (int i = 0; i < kMaxEdges; ++i) {
    scene.view.edges.push_back({Point(i, 0.0), Point(i, 1.0), static_cast<float>(i), 0.1F, 3});
  }
  scene.view.rollouts.assign(9, std::vector<Point>{Point(0.0, 0.0), Point(90.0, 0.0)});
  for (auto _ : state) benchmark::DoNotOptimize(treeMarkers(scene, 1.0, std_msgs::Header()));
}
BENCHMARK(drawTree)->Unit(benchmark::kMillisecond);

void drawBeliefs(benchmark::State& state) {
  const CrowdBelief crowd = people(static_cast<int>(state.range(0)));
  const std::vector<std::int64_t> attended = {1, 2, 3, 4, 5, 6};
  CrowdTrails trails;
  trails.see(crowd);
  for (auto _ : state) {
    const BeliefScene scene{crowd, kCorners, attended, trails, Point(50.0, 50.0), -1, 1.0};
    benchmark::DoNotOptimize(beliefMarkers(scene, std_msgs::Header()));
  }
}
BENCHMARK(drawBeliefs)->Arg(100)->Arg(400)->Arg(1000)->Unit(benchmark::kMillisecond);

// Argument: side of the field [m].
void drawArrivalTime(benchmark::State& state) {
  const StaticMap map = field(static_cast<double>(state.range(0)));
  const Guidance guidance = plannerOn(map, "2d_fmm")->guidance();
  for (auto _ : state) {
    benchmark::DoNotOptimize(arrivalTimeGrid(*guidance.field, 3.0, std_msgs::Header()));
  }
}
BENCHMARK(drawArrivalTime)->Arg(100)->Arg(200)->Arg(500)->Unit(benchmark::kMillisecond);

void drawRoadmap(benchmark::State& state) {
  const StaticMap map = field(100.0);
  const Guidance guidance = plannerOn(map, "2d_prm")->guidance();
  const auto& prior = dynamic_cast<const RoadmapPrior&>(*guidance.prior);
  for (auto _ : state) benchmark::DoNotOptimize(roadmapMarkers(prior, 1.0, std_msgs::Header()));
}
BENCHMARK(drawRoadmap)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace pomdp_crowd_nav

BENCHMARK_MAIN();
