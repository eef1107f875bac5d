// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/world/static_map.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>

namespace pomdp_crowd_nav {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

StaticMap mapWith(StaticMap::Obstacles obstacles) {
  return StaticMap(Bounds{{0.0, 0.0}, {20.0, 10.0}}, std::move(obstacles));
}

StaticMap::Obstacles only(const Polygon& polygon) { return {{}, {polygon}, {}}; }

OccupancyGrid gridWithOneBlockedCell() {
  OccupancyGrid grid{{2.0, 1.0}, 0.5, 10, 6, std::vector<char>(60, 0)};
  grid.blocked[3 * 10 + 4] = 1;  // centre (4.25, 2.75)
  return grid;
}

std::string rejection(const Bounds& bounds, StaticMap::Obstacles obstacles) {
  try {
    StaticMap(bounds, std::move(obstacles));
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "accepted";
}

TEST(StaticMapTest, ClearanceIsInfiniteWithoutObstacles) {
  const StaticMap map = mapWith({});
  EXPECT_FALSE(map.hasObstacles());
  EXPECT_EQ(map.clearance({1.0, 1.0}), kInfinity);
  EXPECT_EQ(map.bounds().max, Point(20.0, 10.0));
}

TEST(StaticMapTest, ClearanceOfACircleIsSigned) {
  const StaticMap map = mapWith({{{{5.0, 5.0}, 2.0}, {{15.0, 5.0}, 1.0}}, {}, {}});
  EXPECT_TRUE(map.hasObstacles());
  EXPECT_DOUBLE_EQ(map.clearance({8.0, 9.0}), 3.0);
  EXPECT_DOUBLE_EQ(map.clearance({5.0, 5.5}), -1.5);
  EXPECT_DOUBLE_EQ(map.clearance({13.0, 5.0}), 1.0);
  EXPECT_DOUBLE_EQ(map.clearance({-10.0, 5.0}), 13.0);  // also off the bounds
}

TEST(StaticMapTest, ClosedPolygonIsSolid) {
  const StaticMap map = mapWith(only({{{4.0, 2.0}, {10.0, 2.0}, {10.0, 6.0}, {4.0, 6.0}}, true}));
  EXPECT_DOUBLE_EQ(map.clearance({1.0, 4.0}), 3.0);
  EXPECT_DOUBLE_EQ(map.clearance({13.0, 10.0}), 5.0);
  EXPECT_DOUBLE_EQ(map.clearance({4.5, 4.0}), -0.5);  // the edge that closes it counts
  EXPECT_DOUBLE_EQ(map.clearance({8.0, 4.0}), -2.0);
}

TEST(StaticMapTest, OpenPolygonIsAWallWithoutThickness) {
  const StaticMap map = mapWith(only({{{4.0, 2.0}, {10.0, 2.0}, {10.0, 6.0}, {4.0, 6.0}}, false}));
  EXPECT_DOUBLE_EQ(map.clearance({4.5, 4.0}), 2.0);
  EXPECT_DOUBLE_EQ(map.clearance({8.0, 2.0}), 0.0);
  EXPECT_DOUBLE_EQ(map.clearance({9.0, 4.0}), 1.0);
}

TEST(StaticMapTest, NearestObstacleOfAnyKindCounts) {
  StaticMap::Obstacles obstacles = only({{{8.0, 0.0}, {8.0, 10.0}}, false});
  obstacles.circles = {{{14.0, 5.0}, 1.0}};
  obstacles.grid = gridWithOneBlockedCell();
  const StaticMap map = mapWith(obstacles);
  EXPECT_DOUBLE_EQ(map.clearance({9.0, 5.0}), 1.0);
  EXPECT_DOUBLE_EQ(map.clearance({12.0, 5.0}), 1.0);
  EXPECT_NEAR(map.clearance({4.25, 3.75}), 0.75, 1e-6);
}

TEST(StaticMapTest, GridClearanceIsToTheNearestBlockedCell) {
  const StaticMap map = mapWith({{}, {}, gridWithOneBlockedCell()});
  EXPECT_TRUE(map.hasObstacles());
  EXPECT_NEAR(map.clearance({4.25, 2.75}), -0.25, 1e-6);
  EXPECT_NEAR(map.clearance({4.49, 2.51}), -0.25, 1e-6);  // anywhere in the cell
  EXPECT_NEAR(map.clearance({5.75, 2.75}), 1.25, 1e-6);
  EXPECT_NEAR(map.clearance({5.75, 1.25}), std::hypot(1.5, 1.5) - 0.25, 1e-6);
  EXPECT_FALSE(mapWith({{}, {}, OccupancyGrid{{0.0, 0.0}, 1.0, 2, 1, {0, 0}}}).hasObstacles());
}

TEST(StaticMapTest, GridClearanceOffTheGridIsNeverTooLarge) {
  const OccupancyGrid grid = gridWithOneBlockedCell();
  const StaticMap map = mapWith({{}, {}, grid});
  for (double x = -3.0; x < 12.0; x += 0.31) {
    for (double y = -3.0; y < 9.0; y += 0.31) {
      const bool on_grid = x >= 2.0 && x <= 7.0 && y >= 1.0 && y <= 4.0;
      if (on_grid) continue;
      const double exact = (Point(x, y) - Point(4.25, 2.75)).norm() - 0.25;
      ASSERT_LE(map.clearance({x, y}), exact + 1e-6) << x << ' ' << y;
      ASSERT_GE(map.clearance({x, y}), 0.6 * exact - 0.5) << x << ' ' << y;
    }
  }
}

// Many shapes are found through a tree; it must agree with the plain loop everywhere.
TEST(StaticMapTest, ManyObstaclesGiveTheClearanceOfThePlainLoop) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  StaticMap::Obstacles obstacles;
  std::vector<Polygon>& polygons = obstacles.polygons;
  for (int i = 0; i < 60; ++i) {
    const Point center(20.0 * unit(random), 10.0 * unit(random));
    Polygon polygon{{}, i % 3 != 0};
    for (int corner = 0; corner < 7; ++corner) {
      polygon.vertices.push_back(center + 0.7 * unit(random) * unitVector(0.9 * corner));
    }
    polygons.push_back(polygon);
    if (i % 2 == 0) obstacles.circles.push_back({center + Point(1.0, 0.5), 0.3 * unit(random)});
  }
  const StaticMap map = mapWith(obstacles);
  for (int i = 0; i < 20000; ++i) {
    const Point point(22.0 * unit(random) - 1.0, 12.0 * unit(random) - 1.0);
    double circles = kInfinity, edges = kInfinity;
    bool inside = false;
    for (const Circle& circle : obstacles.circles) {
      circles = std::min(circles, (point - circle.center).norm() - circle.radius);
    }
    for (const Polygon& polygon : polygons) {
      const auto& corners = polygon.vertices;
      for (size_t k = polygon.closed ? 0 : 1; k < corners.size(); ++k) {
        const Point& before = corners[(k + corners.size() - 1) % corners.size()];
        edges = std::min(edges, distanceToSegment(point, before, corners[k]));
      }
      inside = inside || (polygon.closed && isInsidePolygon(point, corners));
    }
    ASSERT_NEAR(map.clearance(point), std::min(circles, inside ? -edges : edges), 1e-12);
  }
}

TEST(StaticMapTest, RejectsWhatIsNoMap) {
  const Bounds field{{0.0, 0.0}, {10.0, 10.0}};
  EXPECT_EQ(rejection({{0.5, 0.5}, {10.5, 0.5}}, {}),
            "map: bounds must not be empty, got (0.5, 0.5) to (10.5, 0.5)");
  EXPECT_EQ(rejection(field, {{{{1.0, 1.0}, 1.0}, {{2.0, 2.0}, -0.5}}, {}, {}}),
            "map: radius of circle 1 must be positive, got -0.5");
  EXPECT_NE(rejection(field, {{{{std::nan(""), 1.0}, 1.0}}, {}, {}}), "accepted");
  EXPECT_EQ(rejection(field, only({{{1.0, 1.0}, {2.0, 2.0}}, true})),
            "map: closed polygon 0 needs at least 3 vertices, got 2");
  EXPECT_EQ(rejection(field, only({{{1.0, 1.0}}, false})),
            "map: open polygon 0 needs at least 2 vertices, got 1");
  EXPECT_EQ(rejection(field, only({{{1.0, 1.0}, {2.0, kInfinity}}, false})),
            "map: vertices of polygon 0 must be finite, got (2, inf)");
}

TEST(StaticMapTest, RejectsAGridThatDoesNotMatchItsCells) {
  const Bounds field{{0.0, 0.0}, {10.0, 10.0}};
  OccupancyGrid grid = gridWithOneBlockedCell();
  grid.rows = 7;
  EXPECT_EQ(rejection(field, {{}, {}, grid}),
            "map: grid of 10 columns by 7 rows does not match its 60 cells");
  grid.rows = -6;
  EXPECT_NE(rejection(field, {{}, {}, grid}), "accepted");
  grid = gridWithOneBlockedCell();
  grid.resolution = -0.5;
  EXPECT_EQ(rejection(field, {{}, {}, grid}), "map: grid resolution must be positive, got -0.5");
}

}  // namespace
}  // namespace pomdp_crowd_nav
