// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/prior/fast_marching_prior.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <string>

namespace pomdp_crowd_nav {
namespace {

StaticMap mapWith(std::vector<Circle> circles) {
  StaticMap::Obstacles obstacles;
  obstacles.circles = std::move(circles);
  return StaticMap(Bounds{{0.0, 0.0}, {40.0, 40.0}}, obstacles);
}

double offBearing(const RolloutPrior& prior, const Point& place) {
  return std::abs(wrapAngle(*prior.directionAt({place, 0.0}) - bearing(place, prior.goal())));
}

std::string rejection(const PriorParams& params) {
  try {
    makeSpeedMap(mapWith({}), params);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "accepted";
}

TEST(FastMarchingPriorTest, SpeedFallsInsideTheClearanceAndAgainBesideTheObstacle) {
  PriorParams params;
  params.clearance = 3.0;
  params.extra_clearance = 0.5;
  params.robot_radius = 1.0;
  params.blocked_speed = 0.02;
  params.narrow_speed = 0.2;
  const SpeedMap map = makeSpeedMap(mapWith({{{20.1, 20.1}, 4.9}}), params);  // to x = 25
  const auto speedAt = [&](double x) {
    const Point place(x, 20.1);
    return map.speed[map.grid.index(map.grid.columnOf(place), map.grid.rowOf(place))];
  };
  EXPECT_EQ(map.grid.columns, 200);
  EXPECT_FLOAT_EQ(speedAt(28.7), 1.0F);
  EXPECT_FLOAT_EQ(speedAt(28.3), 0.2F);
  EXPECT_FLOAT_EQ(speedAt(26.1), 0.2F) << "there is room for the robot";
  EXPECT_FLOAT_EQ(speedAt(25.9), 0.02F);
  EXPECT_FLOAT_EQ(speedAt(25.3), 0.02F);
  EXPECT_FLOAT_EQ(speedAt(25.1), 0.002F) << "the obstacle may touch the cell";
  EXPECT_FLOAT_EQ(speedAt(24.9), 0.002F);
}

TEST(FastMarchingPriorTest, PointsAtTheGoalOnAFreeField) {
  for (const Point& goal : {Point(23.0, 31.0), Point(5.0, 9.0)}) {
    const FastMarchingPrior prior(mapWith({}), goal, PriorParams());
    for (double x = 0.0; x <= 40.0; x += 0.73) {
      for (double y = 0.0; y <= 40.0; y += 0.73) {
        ASSERT_LT(offBearing(prior, {x, y}), 0.03) << "at " << x << ' ' << y;
      }
    }
  }
}

TEST(FastMarchingPriorTest, PointsAtAGoalOnTheBorderAlsoFromTheBorder) {
  const FastMarchingPrior prior(mapWith({}), {40.0, 30.0}, PriorParams());
  for (double y = 0.0; y <= 40.0; y += 0.37) {
    if (std::abs(y - 30.0) < 0.2) continue;
    ASSERT_LT(offBearing(prior, {40.0, y}), 0.1) << "at 40 " << y;
    ASSERT_LT(offBearing(prior, {0.0, y}), 0.1) << "at 0 " << y;
  }
}

TEST(FastMarchingPriorTest, LastCellsAreDrivenStraight) {
  const Point goal(20.03, 20.11);
  const FastMarchingPrior prior(mapWith({}), goal, PriorParams());
  for (double angle = -3.0; angle < 3.0; angle += 0.1) {
    const Point place = goal - 0.4 * unitVector(angle);
    EXPECT_NEAR(*prior.directionAt({place, 0.0}), angle, 1e-9);
    EXPECT_NEAR(prior.distanceToGoal(place), 0.4, 1e-9);
  }
  EXPECT_DOUBLE_EQ(prior.distanceToGoal(goal), 0.0);
}

// From straight behind a disc both ways round are equally long.
TEST(FastMarchingPriorTest, DecidesBetweenTwoEqualWaysRound) {
  const Circle disc{{20.0, 20.0}, 3.0};
  const StaticMap map = mapWith({disc});
  const PriorParams params;
  const FastMarchingPrior prior(map, {35.0, 20.0}, params);
  Pose pose{{5.0, 20.0}, 0.0};
  double length = 0.0;
  for (; (pose.position - prior.goal()).norm() > 0.1 && length < 100.0; length += 0.1) {
    pose.heading = *prior.directionAt(pose);
    pose.position += 0.1 * unitVector(pose.heading);
    ASSERT_GE(map.clearance(pose.position), params.clearance);
  }
  const double radius = disc.radius + params.clearance + params.extra_clearance;
  const double tangent = std::sqrt(15.0 * 15.0 - radius * radius);
  const double shortest = 2.0 * tangent + radius * (M_PI - 2.0 * std::acos(radius / 15.0));
  EXPECT_NEAR(length, shortest, 0.6);
  EXPECT_NEAR(prior.distanceToGoal({5.0, 20.0}), shortest, 0.4);
}

TEST(FastMarchingPriorTest, LongStepsAlongAnObstacleAreNotThrownOutward) {
  const Circle disc{{20.0, 20.0}, 5.0};
  const FastMarchingPrior prior(mapWith({disc}), {38.0, 21.0}, PriorParams());
  double turned = 0.0;
  Pose pose{{2.0, 18.0}, *prior.directionAt({{2.0, 18.0}, 0.0})};
  for (int step = 0; step < 40 && (pose.position - prior.goal()).norm() > 1.0; ++step) {
    const double heading = *prior.directionAt(pose);
    turned += std::abs(wrapAngle(heading - pose.heading));
    pose = {pose.position + unitVector(heading), heading};
  }
  EXPECT_LE((pose.position - prior.goal()).norm(), 1.0);
  EXPECT_LT(turned, 2.0);  // [rad]; the shortest path turns by 1
}

TEST(FastMarchingPriorTest, LeadsOutOfAnObstacleTheShortWay) {
  const Circle disc{{20.0, 20.0}, 5.0};
  const StaticMap map = mapWith({disc});
  const FastMarchingPrior prior(map, {38.0, 20.0}, PriorParams());
  Pose pose{{16.5, 20.3}, 0.0};  // on the far side from the goal
  double inside = 0.0;
  double length = 0.0;
  for (; (pose.position - prior.goal()).norm() > 0.1 && length < 100.0; length += 0.1) {
    if (map.clearance(pose.position) < 0.0) inside += 0.1;
    pose.position += 0.1 * unitVector(*prior.directionAt(pose));
  }
  EXPECT_LT(length, 100.0);
  EXPECT_LT(inside, 2.0);  // [m]; 1.5 m to the edge
}

TEST(FastMarchingPriorTest, WallOfOneCellIsGoneRound) {
  StaticMap::Obstacles obstacles;
  obstacles.polygons = {{{{20.1, 0.0}, {20.1, 25.1}}, false}};
  const StaticMap map(Bounds{{0.0, 0.0}, {40.0, 40.0}}, obstacles);
  PriorParams params;
  params.clearance = 0.05;
  params.extra_clearance = 0.0;
  params.blocked_speed = 1e-3;  // 200 s through the wall
  const FastMarchingPrior prior(map, {23.0, 10.0}, params);
  for (double y = 1.1; y < 25.0; y += 0.57) {
    ASSERT_GT(*prior.directionAt({{19.7, y}, 0.0}), M_PI / 4.0) << "at y " << y;
  }
  EXPECT_NEAR(prior.distanceToGoal({19.7, 10.0}), 15.1 + std::hypot(2.9, 15.1), 1.0);
}

// A wall of no thickness right across the field, with a door of 1 m. It has room for the robot, but
// leaves it less than is wanted on either side.
TEST(FastMarchingPriorTest, ANarrowDoorIsTakenAndTheThinWallBesideItNeverCrossed) {
  constexpr double kWall = 20.0, kLow = 29.5, kHigh = 30.5;  // [m]
  StaticMap::Obstacles obstacles;
  obstacles.polygons = {{{{kWall, 0.0}, {kWall, kLow}}, false},
                        {{{kWall, kHigh}, {kWall, 40.0}}, false}};
  const StaticMap map(Bounds{{0.0, 0.0}, {40.0, 40.0}}, obstacles);
  PriorParams params;
  params.robot_radius = 0.3;
  params.clearance = 0.7;
  const FastMarchingPrior prior(map, {30.0, 5.0}, params);
  for (double y = 1.1; y < 39.0; y += 3.7) {
    Point place(15.0, y);
    double length = 0.0;
    for (; (place - prior.goal()).norm() > 0.1 && length < 100.0; length += 0.05) {
      const Point next = place + 0.05 * unitVector(*prior.directionAt({place, 0.0}));
      if ((place.x() < kWall) != (next.x() < kWall)) {
        ASSERT_GT(next.y(), kLow + 0.3) << "from y " << y;
        ASSERT_LT(next.y(), kHigh - 0.3) << "from y " << y;
      }
      place = next;
    }
    EXPECT_LT(length, 100.0) << "from y " << y;
  }
}

TEST(FastMarchingPriorTest, DistanceIsTrueLengthForAGoalInsideTheClearance) {
  const StaticMap map = mapWith({{{20.0, 20.0}, 5.0}});
  const FastMarchingPrior prior(map, {26.5, 20.0}, PriorParams());
  EXPECT_NEAR(prior.distanceToGoal({38.0, 20.0}), 11.5, 0.2);
}

TEST(FastMarchingPriorTest, KnowsNoWayFromOffTheGrid) {
  const FastMarchingPrior prior(mapWith({}), {20.0, 20.0}, PriorParams());
  EXPECT_FALSE(prior.directionAt({{40.1, 20.0}, 0.0}));
  EXPECT_TRUE(std::isinf(prior.distanceToGoal({20.0, -0.1})));
  EXPECT_TRUE(prior.directionAt({{40.0, 0.0}, 0.0}));
}

TEST(FastMarchingPriorTest, RejectsParametersOutOfRange) {
  PriorParams params;
  EXPECT_EQ(rejection(params), "accepted");
  params.blocked_speed = 1.2;
  EXPECT_EQ(rejection(params), "prior.blocked_speed must be in (0, 1), got 1.2");
  params.blocked_speed = -0.5;
  EXPECT_EQ(rejection(params), "prior.blocked_speed must be in (0, 1), got -0.5");
  params = PriorParams();
  params.narrow_speed = 0.001;
  EXPECT_EQ(rejection(params),
            "prior.narrow_speed must be between prior.blocked_speed and 1, got 0.001");
  params = PriorParams();
  params.resolution = -0.1;
  EXPECT_EQ(rejection(params), "prior.resolution must be positive, got -0.1");
  params.resolution = 1e-6;
  EXPECT_NE(rejection(params).find("1e-06"), std::string::npos);
  params = PriorParams();
  params.extra_clearance = -0.5;
  EXPECT_EQ(rejection(params), "prior.extra_clearance must be at least 0, got -0.5");
}

}  // namespace
}  // namespace pomdp_crowd_nav
