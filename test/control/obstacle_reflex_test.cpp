// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/control/obstacle_reflex.h"

#include <gtest/gtest.h>

namespace pomdp_crowd_nav {
namespace {

VehicleParams movo() {
  VehicleParams vehicle;
  vehicle.radius = 0.5;
  vehicle.max_speed = 1.0;
  vehicle.brake_deceleration = 1.0;
  vehicle.instant_velocity = false;
  return vehicle;
}

const ObstacleReflex kReflex(movo(), 0.3);

// A wall at x = 10.
StaticMap wall() {
  StaticMap::Obstacles obstacles;
  obstacles.polygons.push_back({{Point(10.0, 0.0), Point(10.0, 20.0)}, false});
  return {Bounds{Point(0.0, 0.0), Point(20.0, 20.0)}, obstacles};
}

TEST(ObstacleReflex, BrakesWhereRestComesTooLate) {
  const StaticMap map = wall();
  // Rest after 0.3 m of reaction and 0.5 m of braking, 0.5 m of radius from the wall.
  EXPECT_FALSE(kReflex.mustBrake({{8.5, 10.0}, 0.0, 1.0}, map));
  EXPECT_TRUE(kReflex.mustBrake({{8.8, 10.0}, 0.0, 1.0}, map));
  EXPECT_FALSE(kReflex.mustBrake({{8.8, 10.0}, 0.0, 0.4}, map)) << "slower";
  EXPECT_FALSE(kReflex.mustBrake({{8.8, 10.0}, M_PI_2, 1.0}, map)) << "along the wall";
}

TEST(ObstacleReflex, NeverBrakesWithoutObstacles) {
  const StaticMap map(Bounds{Point(0.0, 0.0), Point(20.0, 20.0)}, {});
  EXPECT_FALSE(kReflex.mustBrake({{10.0, 10.0}, 0.0, 1.0}, map));
}

TEST(ObstacleReflex, LetsARobotOutOfAnObstacle) {
  const StaticMap map = wall();
  EXPECT_FALSE(kReflex.mustBrake({{9.8, 10.0}, M_PI, 0.5}, map));
  EXPECT_TRUE(kReflex.mustBrake({{9.8, 10.0}, 0.0, 0.5}, map));
}

// As after a map update: in a grid all that is inside an obstacle is at the same distance of it.
TEST(ObstacleReflex, LetsARobotInsideABlockOfAGridOutAndNoDeeper) {
  OccupancyGrid grid;
  grid.resolution = 0.1;
  grid.columns = grid.rows = 200;
  grid.blocked.assign(200 * 200, 0);
  for (int row = 0; row < 200; ++row) {
    for (int column = 100; column < 180; ++column) grid.blocked[row * 200 + column] = 1;
  }
  StaticMap::Obstacles obstacles;
  obstacles.grid = grid;
  const StaticMap map(Bounds{Point(0.0, 0.0), Point(20.0, 20.0)}, obstacles);
  const auto brakes = [&](double heading, double speed) {
    return kReflex.mustBrake({{10.35, 10.0}, heading, speed}, map);
  };
  EXPECT_TRUE(brakes(0.0, 0.5)) << "deeper";
  EXPECT_TRUE(brakes(0.0, 0.1)) << "slowly too";
  EXPECT_TRUE(brakes(M_PI_2, 0.5)) << "along inside";
  EXPECT_FALSE(brakes(M_PI, 0.5)) << "out";
  EXPECT_FALSE(brakes(M_PI, 0.1)) << "slowly too";
  EXPECT_FALSE(brakes(0.0, 0.0)) << "it may stand";
}

TEST(ObstacleReflex, LooksAlongAMotionToRest) {
  const StaticMap map = wall();
  const auto start = [](double x, double heading) {
    return stepMotion(movo(), VehicleState{{x, 10.0}, heading, 0.0}, heading, 0.5, 0.5);
  };
  EXPECT_FALSE(kReflex.hits(start(8.5, 0.0), map));
  EXPECT_TRUE(kReflex.hits(start(9.2, 0.0), map));
  EXPECT_FALSE(kReflex.hits(start(9.2, M_PI), map));
  StepMotion rest;
  rest.start = Point(9.2, 10.0);
  EXPECT_FALSE(kReflex.hits(rest, map)) << "standing beside a wall is allowed";
}

}  // namespace
}  // namespace pomdp_crowd_nav
