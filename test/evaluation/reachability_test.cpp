// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/evaluation/reachability.h"

#include <gtest/gtest.h>

#include "pomdp_crowd_nav/planner/planner_factory.h"

namespace pomdp_crowd_nav {
namespace {

constexpr double kRadius = 2.0;  // [m], of an obstacle at (10, 0)

class NoWay : public testing::Test {
 protected:
  static StaticMap map() {
    StaticMap::Obstacles obstacles;
    obstacles.circles.push_back({Point(10.0, 0.0), kRadius});
    return StaticMap(Bounds{Point(-50.0, -50.0), Point(50.0, 50.0)}, obstacles);
  }

  NoWay() { params_.model.goal_tolerance = 0.5; }

  std::string why(const std::vector<Point>& path) const {
    return whyNoWay(path, Point(20.0, 0.0), map_, params_.model);
  }

  // Of the planner's own path past the obstacle.
  std::string whyOf(const std::string& planner) {
    params_.model.vehicle.kind =
        drives(planner, VehicleKind::kCar) ? VehicleKind::kCar : VehicleKind::kHolonomic;
    const Way way{{0.0, 0.0}, {20.0, 0.0}};
    const auto made = makePlanner(planner, {map_, way.goal, {{-50.0, -50.0}}}, params_);
    return whyNoWay(*made, way, map_, params_.model);
  }

  PlannerParams params_;
  StaticMap map_ = map();
};

TEST_F(NoWay, PathRoundTheObstacleIsAWay) {
  EXPECT_EQ(why({{0.0, 0.0}, {10.0, 5.0}, {20.0, 0.0}}), "");
}

TEST_F(NoWay, PathThroughTheObstacleIsNone) {
  const std::string reason = why({{0.0, 0.0}, {20.0, 0.0}});
  EXPECT_NE(reason.find("no way to the goal"), std::string::npos);
  EXPECT_NE(reason.find("obstacle"), std::string::npos);
}

TEST_F(NoWay, PathThroughAWallOfNoThicknessIsNone) {
  StaticMap::Obstacles wall;
  wall.polygons.push_back({{Point(7.03, -50.0), Point(7.03, 50.0)}, false});
  map_ = StaticMap(map_.bounds(), wall);
  EXPECT_NE(why({{0.0, 0.0}, {20.0, 0.0}}), "");
}

TEST_F(NoWay, PathThatEndsBeforeTheGoalIsNone) {
  EXPECT_NE(why({{0.0, 0.0}, {10.0, 5.0}, {18.5, 0.0}}), "");
  EXPECT_EQ(why({{0.0, 0.0}, {10.0, 5.0}, {19.1, 0.0}}), "") << "near enough";
}

TEST_F(NoWay, RobotInsideAnObstacleMayDriveOut) {
  EXPECT_EQ(why({{11.5, 0.0}, {13.0, 0.0}, {20.0, 0.0}}), "");
  EXPECT_NE(why({{11.5, 0.0}}), "");
}

TEST_F(NoWay, EveryPlannerMayDriveRoundAnObstacle) {
  for (const std::string& planner : plannerNames()) EXPECT_EQ(whyOf(planner), "") << planner;
}

TEST_F(NoWay, BehindAWallABeelineIsNotJudgedAndEveryOtherPathIsNone) {
  StaticMap::Obstacles wall;
  wall.polygons.push_back({{Point(7.03, -51.0), Point(7.03, 51.0)}, false});
  map_ = StaticMap(map_.bounds(), wall);
  for (const std::string& planner : plannerNames()) {
    const bool is_blind = planner == "2d_straight" || planner == "2d_nhv";
    EXPECT_EQ(whyOf(planner).empty(), is_blind) << planner;
  }
}

}  // namespace
}  // namespace pomdp_crowd_nav
