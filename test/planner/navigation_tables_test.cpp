// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/planner/navigation_tables.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "pomdp_crowd_nav/pomdp/upper_bound.h"
#include "pomdp_crowd_nav/prior/prior_factory.h"

namespace pomdp_crowd_nav {
namespace {

const Point kGoal(17.0, 3.0);

StaticMap walledMap() {
  StaticMap::Obstacles obstacles;
  obstacles.polygons = {{{{10.0, 0.0}, {10.0, 9.0}}, false}};
  return {Bounds{Point(0.0, 0.0), Point(20.0, 15.0)}, obstacles};
}

ModelParams smallRobot() {
  ModelParams model;
  model.vehicle.radius = 0.5;
  model.vehicle.max_speed = 1.0;
  model.obstacle_distance = 0.4;
  model.step = 0.5;
  return model;
}

TEST(NavigationTablesTest, AreThoseMadeOneAfterTheOther) {
  const ClearanceGrid map(walledMap(), 0.2);
  const auto prior = makePrior("fast_marching", map, kGoal, {});
  const NavigationTables tables([&] { return prior; }, map, kGoal, smallRobot());
  EXPECT_EQ(tables.prior, prior);
  const NavigationField field(*prior, map);
  const auto shortest_way = makeShortestWay(smallRobot(), map, kGoal);
  ASSERT_TRUE(shortest_way && tables.shortest_way);
  EXPECT_GT(shortest_way->lengthFrom(3.0F, 3.0F), 17.0F) << "round the wall";
  for (float x = 0.1F; x < 20.0F; x += 0.7F) {
    for (float y = 0.1F; y < 15.0F; y += 0.7F) {
      EXPECT_EQ(tables.shortest_way->lengthFrom(x, y), shortest_way->lengthFrom(x, y));
      EXPECT_EQ(tables.field.at(x, y).direction_x, field.at(x, y).direction_x);
      EXPECT_EQ(tables.field.at(x, y).distance_to_goal, field.at(x, y).distance_to_goal);
    }
  }
}

TEST(NavigationTablesTest, ThrowWhatThePriorThrows) {
  const ClearanceGrid map(walledMap(), 0.2);
  const auto make_prior = [&] { return makePrior("fast_marching", map, {30.0, 3.0}, {}); };
  EXPECT_THROW(NavigationTables(make_prior, map, kGoal, smallRobot()), std::invalid_argument);
}

TEST(NavigationTablesTest, KnowNoShortestWayWhereThereAreNoObstacles) {
  const ClearanceGrid map(StaticMap(walledMap().bounds(), {}), 0.2);
  const auto make_prior = [&] { return makePrior("straight_line", map, kGoal, {}); };
  EXPECT_FALSE(NavigationTables(make_prior, map, kGoal, smallRobot()).shortest_way);
}

}  // namespace
}  // namespace pomdp_crowd_nav
