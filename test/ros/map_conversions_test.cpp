// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/ros/map_conversions.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "pomdp_crowd_nav/ros/conversions.h"

namespace pomdp_crowd_nav {
namespace {

nav_msgs::OccupancyGrid smallGrid() {
  nav_msgs::OccupancyGrid grid;
  grid.info.resolution = 0.5F;
  grid.info.width = 4;
  grid.info.height = 2;
  grid.info.origin = toMessage(Pose{Point(-1.0, 0.0), 0.0});
  grid.data = {0, 0, 0, 100, 0, 0, 0, -1};
  return grid;
}

TEST(Maps, OccupiedAndUnknownCellsAreBlocked) {
  const auto map = toStaticMap(smallGrid());
  EXPECT_EQ(map->bounds().max, Point(1.0, 1.0));
  EXPECT_LE(map->clearance(Point(0.75, 0.25)), 0.0);
  EXPECT_LE(map->clearance(Point(0.75, 0.75)), 0.0);
  EXPECT_GT(map->clearance(Point(-0.75, 0.25)), 0.5);
}

TEST(Maps, OfAnotherSizeOrTurnedAreRefused) {
  nav_msgs::OccupancyGrid grid = smallGrid();
  grid.data.pop_back();
  EXPECT_THROW(toStaticMap(grid), std::invalid_argument);
  grid = smallGrid();
  grid.info.origin = toMessage(Pose{Point(0.0, 0.0), 0.5});
  EXPECT_THROW(toStaticMap(grid), std::invalid_argument);
  EXPECT_THROW(toStaticMap(nav_msgs::OccupancyGrid()), std::invalid_argument);
}

TEST(Maps, GridOfAMapShowsItsObstacles) {
  StaticMap::Obstacles obstacles;
  obstacles.circles.push_back({Point(5.0, 5.0), 2.0});
  const StaticMap map(Bounds{Point(0.0, 0.0), Point(10.0, 10.0)}, obstacles);
  const nav_msgs::OccupancyGrid grid = toMessage(map, 0.5, std_msgs::Header());
  ASSERT_EQ(grid.data.size(), 400u);
  EXPECT_EQ(grid.data[10 * 20 + 10], 100);
  EXPECT_EQ(grid.data[0], 0);
}

TEST(Maps, DrawingOfAMapIsKnownFromAnother) {
  StaticMap::Obstacles obstacles;
  obstacles.circles.push_back({Point(5.0, 5.0), 2.0});
  obstacles.polygons.push_back({{Point(1.0, 1.0), Point(8.0, 1.0)}, false});
  const Bounds bounds{Point(0.0, 0.0), Point(10.0, 9.97)};
  const StaticMap map(bounds, obstacles);
  nav_msgs::OccupancyGrid grid = toMessage(map, 0.1, std_msgs::Header());
  EXPECT_TRUE(isDrawingOf(map, grid));
  obstacles.circles[0].center.x() += 0.2;
  EXPECT_FALSE(isDrawingOf(StaticMap(bounds, obstacles), grid));
  obstacles.circles[0].center.x() -= 0.2;
  obstacles.polygons.clear();
  EXPECT_FALSE(isDrawingOf(StaticMap(bounds, obstacles), grid)) << "a wall has gone";
  EXPECT_FALSE(isDrawingOf(StaticMap({Point(0.0, 0.0), Point(20.0, 9.97)}, {}), grid));
  grid.data.pop_back();
  EXPECT_FALSE(isDrawingOf(map, grid));
  EXPECT_FALSE(isDrawingOf(map, nav_msgs::OccupancyGrid()));
}

}  // namespace
}  // namespace pomdp_crowd_nav
