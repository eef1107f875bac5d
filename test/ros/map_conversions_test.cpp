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

TEST(Maps, UnknownSpaceAndThresholdAreAChoice) {
  nav_msgs::OccupancyGrid grid = smallGrid();
  grid.data = {0, 50, 64, 65, 0, 0, 101, -1};
  const Point fifty(-0.25, 0.25), sixty_five(0.75, 0.25), odd(0.25, 0.75), unknown(0.75, 0.75);
  const auto standard = toStaticMap(grid);
  EXPECT_GT(standard->clearance(fifty), 0.0);
  EXPECT_LE(standard->clearance(sixty_five), 0.0);
  EXPECT_LE(standard->clearance(odd), 0.0) << "no value of an occupancy grid";
  MapPolicy policy;
  policy.unknown = UnknownSpace::kFree;
  EXPECT_GT(toStaticMap(grid, policy)->clearance(unknown), 0.0);
  EXPECT_LE(toStaticMap(grid, policy)->clearance(sixty_five), 0.0);
  policy.occupied_threshold = 50;
  EXPECT_LE(toStaticMap(grid, policy)->clearance(fifty), 0.0);
}

// Whatever is blocked in a turned grid is blocked at the same place in its frame.
TEST(Maps, TurnedGridKeepsItsObstaclesWhereTheyAre) {
  nav_msgs::OccupancyGrid grid;
  grid.info.resolution = 0.5F;
  grid.info.width = 40;
  grid.info.height = 30;
  grid.data.assign(1200, 0);
  const std::vector<size_t> obstacles = {5 * 40 + 7, 20 * 40 + 33, 12 * 40 + 20, 12 * 40 + 21};
  for (const size_t cell : obstacles) grid.data[cell] = 100;
  for (const double turn : {0.3, -1.2, 2.5, M_PI_2}) {
    const Pose origin{Point(-3.0, 4.0), turn};
    grid.info.origin = toMessage(origin);
    const auto map = toStaticMap(grid);
    const auto place = [&](double column, double row) {
      return transformed(origin, Pose{0.5 * Point(column + 0.5, row + 0.5), 0.0}).position;
    };
    for (const size_t cell : obstacles) {
      const auto column = static_cast<double>(cell % 40), row = static_cast<double>(cell / 40);
      EXPECT_LE(map->clearance(place(column, row)), 0.0) << turn << " " << cell;
    }
    EXPECT_GT(map->clearance(place(14.0, 20.0)), 1.5) << turn;
    EXPECT_TRUE(map->bounds().contains(place(0.0, 0.0)));
    EXPECT_TRUE(map->bounds().contains(place(39.0, 29.0)));
    EXPECT_LE(map->clearance(map->bounds().min + Point(0.1, 0.1)), turn == M_PI_2 ? 1e9 : 0.0)
        << "the corners of the rectangle around it are not on the map";
  }
}

TEST(Maps, OfAnotherSizeAreRefused) {
  nav_msgs::OccupancyGrid grid = smallGrid();
  grid.data.pop_back();
  EXPECT_THROW(toStaticMap(grid), std::invalid_argument);
  grid = smallGrid();
  grid.info.origin.orientation.w = 0.0;
  EXPECT_THROW(toStaticMap(grid), std::invalid_argument) << "no rotation";
  grid = smallGrid();
  grid.info.resolution = 0.0F;
  EXPECT_THROW(toStaticMap(grid), std::invalid_argument);
  EXPECT_THROW(toStaticMap(nav_msgs::OccupancyGrid()), std::invalid_argument);
}

// So far away that a cell is less than the rounding of a coordinate, such a rectangle has none.
TEST(Maps, BeyondEveryCoordinateAreRefused) {
  for (const double turn : {0.0, 0.3}) {
    for (const double far : {1.0e20, -1.0e20, 1.0e300, 1.1e6}) {
      nav_msgs::OccupancyGrid grid = smallGrid();
      grid.info.origin = toMessage(Pose{Point(far, 0.0), turn});
      EXPECT_THROW(toStaticMap(grid), std::invalid_argument) << turn << " " << far;
      grid.info.origin = toMessage(Pose{Point(0.0, far), turn});
      EXPECT_THROW(toStaticMap(grid), std::invalid_argument) << turn << " " << far;
    }
    for (const float resolution : {1.0e-45F, 1.0e-38F, 1.0e-7F, 1.0e6F, 1.0e38F}) {
      nav_msgs::OccupancyGrid grid = smallGrid();
      grid.info.origin = toMessage(Pose{Point(1.0, 2.0), turn});
      grid.info.resolution = resolution;
      EXPECT_THROW(toStaticMap(grid), std::invalid_argument) << turn << " " << resolution;
    }
    nav_msgs::OccupancyGrid grid = smallGrid();
    grid.info.origin = toMessage(Pose{Point(1.0e6, -1.0e6), turn});
    EXPECT_NO_THROW(toStaticMap(grid)) << turn;
    grid.info.resolution = 1.0e-5F;
    EXPECT_NO_THROW(toStaticMap(grid)) << turn;
  }
}

// A long and narrow grid, askew, in a rectangle of 4.2 * 10^9 cells.
TEST(Maps, TurnedGridThatTakesTooManyCellsIsRefused) {
  nav_msgs::OccupancyGrid grid;
  grid.info.resolution = 0.5F;
  grid.info.width = 100000;
  grid.info.height = 1;
  grid.data.assign(100000, 0);
  grid.info.origin = toMessage(Pose{Point(0.0, 0.0), 0.5});
  EXPECT_THROW(toStaticMap(grid), std::invalid_argument);
  grid.info.origin = toMessage(Pose{Point(0.0, 0.0), 0.0});
  EXPECT_NO_THROW(toStaticMap(grid));
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
