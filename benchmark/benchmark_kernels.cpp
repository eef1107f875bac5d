// SPDX-License-Identifier: BSD-3-Clause
// The parts of a decision, each alone (Google Benchmark): expansions for every vector width, the
// table of futures, the upper bound, the prior.
#include <benchmark/benchmark.h>

#include <cmath>
#include <numeric>
#include <random>

#include "pomdp_crowd_nav/pomdp/crowd_model.h"
#include "search_rig.h"

namespace pomdp_crowd_nav {
namespace {

// Where a search looks: up to a dozen steps from the start, on the way to the goal.
struct Visit {
  RobotState state;
  int depth = 0;
};
std::vector<Visit> visits() {
  std::vector<Visit> some;
  std::mt19937 random(1);
  std::uniform_real_distribution<float> unit(0.0F, 1.0F);
  for (int i = 0; i < 400; ++i) {
    const int depth = 1 + i % 12;
    const float way = 1.7F * unit(random) * static_cast<float>(depth);
    some.push_back({{1.0F + 0.9F * way + unit(random), 25.0F + 0.4F * way + unit(random), 0.9F,
                     0.43F, i % 2 == 0 ? 1.0F : 2.0F},
                    depth});
  }
  return some;
}

// Items are model steps.
void expand(benchmark::State& state, const LaneKernel& kernel, int scenario_count) {
  SearchRig rig{SearchRigParams()};
  rig.drawFutures(1);
  const CrowdModel model = rig.model(kernel);
  const std::vector<Visit> where = visits();
  std::vector<int> scenarios(100);
  std::iota(scenarios.begin(), scenarios.end(), 0);
  Expansion<CrowdModel> out;
  long steps = 0;
  size_t i = 0;
  for (auto _ : state) {
    const Visit& visit = where[i % where.size()];
    const int first = static_cast<int>(i) % (101 - scenario_count);
    model.expand(&visit.state, &scenarios[first], scenario_count, visit.depth, out);
    steps += out.model_steps;
    ++i;
  }
  state.SetItemsProcessed(steps);
}

// Argument: people.
void drawFutures(benchmark::State& state) {
  SearchRigParams params;
  params.pedestrians = static_cast<int>(state.range(0));
  SearchRig rig(params);
  for (auto _ : state) rig.drawFutures(1);
}
BENCHMARK(drawFutures)->Arg(6)->Arg(16)->Unit(benchmark::kMillisecond);

// Argument: 0 the paper's, 1 the tight one.
void upperBound(benchmark::State& state) {
  SearchRig rig{SearchRigParams()};
  ModelParams params = rig.params().model;
  params.upper_bound = state.range(0) == 0 ? UpperBoundKind::kPaper : UpperBoundKind::kTight;
  const UpperBound bound(params, rig.prior().goal());
  const std::vector<Visit> where = visits();
  size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(bound.value(where[i % where.size()].state));
    ++i;
  }
}
BENCHMARK(upperBound)->Arg(0)->Arg(1);

void buildPrior(benchmark::State& state) {
  const SearchRig rig{SearchRigParams()};
  for (auto _ : state) benchmark::DoNotOptimize(rig.makeFieldPrior());
}
BENCHMARK(buildPrior)->Unit(benchmark::kMillisecond);

void tabulatePrior(benchmark::State& state) {
  const SearchRig rig{SearchRigParams()};
  for (auto _ : state) {
    const NavigationField field(rig.prior(), rig.map(), rig.params().prior.resolution);
    benchmark::DoNotOptimize(field.directions());
  }
}
BENCHMARK(tabulatePrior)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace pomdp_crowd_nav

int main(int argc, char** argv) {
  using namespace pomdp_crowd_nav;
  for (const LaneKernel* kernel : laneKernels()) {
    for (const int scenarios : {1, 100}) {
      const std::string name =
          std::string("expand/") + kernel->name + "/scenarios:" + std::to_string(scenarios);
      benchmark::RegisterBenchmark(name.c_str(), [kernel, scenarios](benchmark::State& state) {
        expand(state, *kernel, scenarios);
      });
    }
  }
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
