// SPDX-License-Identifier: BSD-3-Clause
// Once its memory has grown, a search takes nothing from the heap.
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <cstdlib>
#include <new>
#include <numeric>

#include "crowd_scene.h"
#include "pomdp_crowd_nav/despot/search.h"

namespace {

std::atomic<long> allocations{0};

}  // namespace

void* operator new(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size == 0 ? 1 : size)) return memory;
  throw std::bad_alloc();
}
void* operator new(std::size_t size, std::align_val_t alignment) {
  ++allocations;
  const auto align = static_cast<std::size_t>(alignment);
  if (void* memory = std::aligned_alloc(align, (size + align - 1) / align * align)) return memory;
  throw std::bad_alloc();
}
void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

namespace pomdp_crowd_nav {
namespace {

TEST(Allocation, IsCountedHere) {
  const long before = allocations;
  const std::vector<int> some(100);
  EXPECT_EQ(allocations - before, 1) << some.size();
}

TEST(Allocation, NoneInAWarmExpansion) {
  const ModelParams params = paperModel();
  const CrowdScene scene(params, {6, 100, true, 1});
  for (const LaneKernel* kernel : laneKernels()) {
    const CrowdModel model(params, scene.field(), scene.futures(), *kernel);
    std::vector<int> scenarios(100);
    std::iota(scenarios.begin(), scenarios.end(), 0);
    Expansion<CrowdModel> out;
    const RobotState moving = RobotState::from({{5.0, 5.0}, 0.0, 1.0});
    model.expand(&moving, scenarios.data(), 100, 0, out);
    std::mt19937_64 random(1);
    const long before = allocations;
    for (int i = 0; i < 50; ++i) {
      const RobotState state = scene.randomState(random);
      model.expand(&state, scenarios.data(), i % 2 == 0 ? 1 : 100, i % 20, out);
    }
    EXPECT_EQ(allocations - before, 0) << kernel->name;
  }
}

// What a search takes before and after its trials does not depend on their number.
TEST(Allocation, NoneInAWarmTrial) {
  ModelParams params = paperModel();
  params.upper_bound = UpperBoundKind::kPaper;  // never closes the gap
  const CrowdScene scene(params, {6, 100, true, 1});
  const CrowdModel model(params, scene.field(), scene.futures());
  SearchParams search_params;
  search_params.scenarios = 100;
  search_params.max_depth = params.depth();
  Search<CrowdModel> search(search_params);
  const std::vector<RobotState> start{RobotState::from({{4.0, 12.0}, 0.0, 0.0})};
  search.run(model, start, SearchLimit::trials(400));
  const auto allocationsOf = [&](long trials) {
    const long before = allocations;
    const auto result = search.run(model, start, SearchLimit::trials(trials));
    EXPECT_EQ(result.statistics.trials, trials) << describe(result.statistics.stop);
    // The plan is as long as the tree is deep.
    return allocations - before - static_cast<long>(std::ceil(std::log2(result.plan.size())));
  };
  EXPECT_LE(allocationsOf(300), allocationsOf(1) + 1);
}

}  // namespace
}  // namespace pomdp_crowd_nav
