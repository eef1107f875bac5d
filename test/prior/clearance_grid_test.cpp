// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/prior/clearance_grid.h"

#include <gtest/gtest.h>

#include "pomdp_crowd_nav/prior/navigation_field.h"
#include "pomdp_crowd_nav/prior/prior_factory.h"

namespace pomdp_crowd_nav {
namespace {

StaticMap gridMap() {
  OccupancyGrid grid;
  grid.resolution = 0.25;
  grid.columns = 80;
  grid.rows = 60;
  for (int row = 0; row < grid.rows; ++row) {
    for (int column = 0; column < grid.columns; ++column) {
      grid.blocked.push_back(row > 20 && column > 38 && column < 42 ? 1 : 0);
    }
  }
  StaticMap::Obstacles obstacles;
  obstacles.grid = grid;
  obstacles.circles.push_back({Point(5.0, 8.0), 1.0});
  return {Bounds{Point(0.0, 0.0), Point(20.0, 15.0)}, obstacles};
}

TEST(ClearanceGrid, HoldsTheClearanceOfTheCentres) {
  const StaticMap map = gridMap();
  const ClearanceGrid sampled(map, 0.2);
  ASSERT_EQ(sampled.clearance.size(), sampled.grid.cellCount());
  for (const int row : {0, 33, 74}) {
    for (const int column : {0, 50, 99}) {
      EXPECT_EQ(sampled.clearance[sampled.grid.index(column, row)],
                map.clearance(sampled.grid.center(column, row)));
    }
  }
  EXPECT_THROW(ClearanceGrid(map, 0.0), std::invalid_argument);
}

// What is shared by goals changes nothing in what each of them gets.
TEST(ClearanceGrid, SharedWorkGivesTheSamePriorsAndTables) {
  const StaticMap map = gridMap();
  PriorParams params;
  params.clearance = 0.8;
  params.milestones = 60;
  const ClearanceGrid sampled(map, params.resolution);
  for (const std::string& name : priorNames()) {
    for (const Point& goal : {Point(17.0, 12.0), Point(2.0, 2.0)}) {
      const NavigationField alone(*makePrior(name, map, goal, params), map, params.resolution);
      const NavigationField shared(*makePrior(name, sampled, goal, params), sampled);
      for (size_t cell = 0; cell < sampled.grid.cellCount(); ++cell) {
        ASSERT_EQ(alone.directions()[cell], shared.directions()[cell]) << name << " " << cell;
        ASSERT_EQ(alone.clearances()[cell], shared.clearances()[cell]) << name << " " << cell;
      }
      for (double x = 0.5; x < 20.0; x += 1.7) {
        const auto y = static_cast<float>(15.0 - 0.6 * x);
        const NavigationCell a = alone.at(static_cast<float>(x), y);
        const NavigationCell b = shared.at(static_cast<float>(x), y);
        EXPECT_EQ(a.distance_to_goal, b.distance_to_goal) << name;
      }
    }
  }
}

}  // namespace
}  // namespace pomdp_crowd_nav
