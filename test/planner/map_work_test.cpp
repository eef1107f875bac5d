// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/planner/map_work.h"

#include <gtest/gtest.h>

#include <thread>
#include <vector>

namespace pomdp_crowd_nav {
namespace {

std::shared_ptr<const StaticMap> discAt(double x) {
  StaticMap::Obstacles obstacles;
  obstacles.circles.push_back({Point(x, 5.0), 1.0});
  return std::make_shared<const StaticMap>(Bounds{Point(0.0, 0.0), Point(10.0, 10.0)}, obstacles);
}

TEST(MapWork, IsDoneOncePerMap) {
  MapWork work(0.5);
  const auto map = discAt(3.0);
  const auto first = work.of(map);
  EXPECT_EQ(work.of(map), first);
  EXPECT_EQ(first->map.clearance({3.0, 5.0}), -1.0);
  const auto second = work.of(discAt(7.0));
  EXPECT_NE(second, first);
  EXPECT_EQ(second->map.clearance({7.0, 5.0}), -1.0);
  EXPECT_EQ(first->map.clearance({3.0, 5.0}), -1.0) << "who holds it keeps it";
}

TEST(MapWork, MayBeAskedByManyThreads) {
  MapWork work(0.05);
  const auto map = discAt(3.0);
  std::vector<std::shared_ptr<const ClearanceGrid>> got(4);
  std::vector<std::thread> threads;
  for (auto& mine : got) threads.emplace_back([&] { mine = work.of(map); });
  for (std::thread& thread : threads) thread.join();
  for (const auto& mine : got) EXPECT_EQ(mine, got.front());
}

}  // namespace
}  // namespace pomdp_crowd_nav
