// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/planner/limited_space_planner.h"

#include <gtest/gtest.h>

#include <cmath>

namespace pomdp_crowd_nav {
namespace {

const std::vector<Point> kCorners{{0.0, 0.0}, {0.0, 30.0}, {40.0, 30.0}, {40.0, 0.0}};

class LimitedSpace : public testing::Test {
 protected:
  LimitedSpace() {
    params_.search.scenarios = 30;
    params_.model.horizon = 40.0;
  }

  std::unique_ptr<LimitedSpacePlanner> make(const Point& goal = {36.0, 20.0}) const {
    return std::make_unique<LimitedSpacePlanner>(Task{map_, goal, kCorners}, params_);
  }

  // One expansion is not enough for any path.
  void allowNoPath() { params_.limited_space.max_expansions = 1; }

  static double lengthOf(const std::vector<PathLeg>& legs) {
    double length = 0.0;
    for (const PathLeg& leg : legs) length += leg.length;
    return length;
  }

  StaticMap map_ = StaticMap({{0.0, 0.0}, {40.0, 30.0}}, {});
  PlannerParams params_;
};

TEST_F(LimitedSpace, AStepDrivesAsManyElementsAsItsSpeed) {
  const auto planner = make();
  VehicleState robot{{3.0, 14.0}, 0.0, 0.0};
  for (int step = 1; step <= 8; ++step) {
    const Decision decision = planner->decide({robot, {}}, SearchLimit::trials(20));
    EXPECT_TRUE(decision.has_fresh_path);
    EXPECT_GT(decision.path_expansions, 0);
    const double speed = std::min(2.0, static_cast<double>(step));
    EXPECT_NEAR(decision.motion.end_velocity.norm(), speed, 1e-6);
    EXPECT_NEAR(lengthOf(decision.motion.legs), speed, 1e-6);
    robot = decision.motion.end();
  }
}

TEST_F(LimitedSpace, ACarDrivesArcsWithoutCorners) {
  params_.model.vehicle.kind = VehicleKind::kCar;
  params_.model.vehicle.max_speed = 4.0;
  const auto planner = make();
  VehicleState robot{{6.0, 14.0}, 3.0, 0.0};
  double time = 0.0;
  while ((robot.position - Point(36.0, 20.0)).norm() > params_.model.goal_tolerance) {
    ASSERT_LT(time, 40.0) << robot.position.transpose();
    const Decision decision = planner->decide({robot, {}}, SearchLimit::trials(20));
    double heading = robot.heading;
    for (const PathLeg& leg : decision.motion.legs) {
      ASSERT_NEAR(wrapAngle(leg.heading - heading), 0.0, 1e-9);
      ASSERT_LE(std::abs(leg.turn), M_PI / 4.0 * leg.length + 1e-9);
      heading = leg.headingAt(leg.length);
    }
    robot = decision.motion.end();
    time += params_.model.step;
  }
  EXPECT_LT(time, 20.0);
}

TEST_F(LimitedSpace, ADecisionTellsItsPath) {
  const auto planner = make();
  const VehicleState robot{{3.0, 14.0}, 0.0, 0.0};
  const Decision decision = planner->decide({robot, {}}, SearchLimit::trials(20));
  ASSERT_GE(decision.path.size(), 100U);
  EXPECT_EQ(decision.path.front(), robot.position);
  EXPECT_EQ(decision.path.back(), Point(36.0, 20.0));
  for (size_t i = 1; i < decision.path.size(); ++i) {
    ASSERT_LE((decision.path[i] - decision.path[i - 1]).norm(), 0.26);
  }
  double off = 1e9;
  const Point end = decision.motion.end().position;
  for (const Point& place : decision.path) off = std::min(off, (place - end).norm());
  EXPECT_LE(off, 0.13) << "the motion is on it";
}

TEST_F(LimitedSpace, TheGlobalPathIsSearchedNoLongerThanADecisions) {
  EXPECT_EQ(make()->globalPath({3.0, 14.0}).back(), Point(36.0, 20.0));
  allowNoPath();
  EXPECT_EQ(make()->globalPath({3.0, 14.0}).size(), 1U);
}

TEST_F(LimitedSpace, WithoutAnyPathTheRobotRests) {
  allowNoPath();
  const auto planner = make();
  const VehicleState robot{{3.0, 14.0}, 0.4, 2.0};
  const Decision decision = planner->decide({robot, {}}, SearchLimit::trials(20));
  EXPECT_FALSE(decision.has_fresh_path);
  EXPECT_FALSE(decision.action.sudden_brake);
  EXPECT_EQ(decision.motion.end().position, robot.position);
  EXPECT_EQ(decision.motion.end().speed, 0.0);
  EXPECT_EQ(decision.motion.end_heading, robot.heading);
  EXPECT_EQ(decision.path, std::vector<Point>{robot.position});
  EXPECT_TRUE(planner->viewTree({100}).edges.empty());
}

// Somebody stands on the goal: no path keeps clear of them, and the old one is driven on.
TEST_F(LimitedSpace, DrivesOnAlongTheOldPathWhereThereIsNoNewOne) {
  params_.limited_space.max_expansions = 3000;
  const auto planner = make();
  VehicleState robot{{3.0, 14.0}, 0.0, 0.0};
  const Decision first = planner->decide({robot, {}}, SearchLimit::trials(20));
  ASSERT_TRUE(first.has_fresh_path);
  const std::vector<Point> way = planner->viewTree({10}).rollouts.at(0);
  robot = first.motion.end();
  for (int step = 0; step < 5; ++step) {
    const CrowdBelief somebody{1.0, {{1, {36.0, 20.0}, {0.0, 0.0}, 1.0, IntentionBelief(4)}}};
    const Decision decision = planner->decide({robot, somebody}, SearchLimit::trials(20));
    EXPECT_FALSE(decision.has_fresh_path);
    robot = decision.motion.end();
    double off = 1e9;
    for (const Point& place : way) off = std::min(off, (place - robot.position).norm());
    EXPECT_LT(off, 1e-6);
  }
  EXPECT_GT(robot.position.x(), 8.0);
}

TEST_F(LimitedSpace, BegunAmongPeopleWithoutAWayThroughItTakesThePathOfAnEmptyField) {
  params_.limited_space.max_expansions = 3000;
  const auto planner = make();
  const CrowdBelief somebody{1.0, {{1, {36.0, 20.0}, {0.0, 0.0}, 1.0, IntentionBelief(4)}}};
  const Decision decision =
      planner->decide({{{3.0, 14.0}, 0.0, 0.0}, somebody}, SearchLimit::trials(20));
  EXPECT_FALSE(decision.has_fresh_path);
  EXPECT_GT(decision.motion.end().speed, 0.0);
}

TEST_F(LimitedSpace, ARobotThatWasPutElsewhereLeavesTheOldPath) {
  const auto planner = make();
  planner->decide({{{3.0, 14.0}, 0.0, 0.0}, {}}, SearchLimit::trials(20));
  const Decision decision = planner->decide({{{20.0, 5.0}, 1.0, 0.0}, {}}, SearchLimit::trials(20));
  EXPECT_EQ(decision.motion.start, Point(20.0, 5.0));
  EXPECT_NEAR((decision.motion.end().position - Point(20.0, 5.0)).norm(), 1.0, 1e-6);
}

TEST_F(LimitedSpace, EndsInTime) {
  const auto planner = make();
  const VehicleState robot{{3.0, 14.0}, 0.0, 0.0};
  planner->decide({robot, {}}, SearchLimit::trials(1));
  const auto begin = SearchLimit::Clock::now();
  const auto deadline = begin + std::chrono::milliseconds(100);
  planner->decide({robot, {}}, SearchLimit::until(deadline));
  EXPECT_LT(SearchLimit::Clock::now() - begin, std::chrono::milliseconds(200));
}

TEST_F(LimitedSpace, AGoalBehindAWallHasNoGlobalPath) {
  StaticMap::Obstacles wall;
  wall.polygons = {{{{25.0, -1.0}, {25.0, 31.0}}, false}};
  map_ = StaticMap(map_.bounds(), wall);
  const std::vector<Point> path = make()->globalPath({3.0, 14.0});
  EXPECT_LT(path.back().x(), 25.0);
}

}  // namespace
}  // namespace pomdp_crowd_nav
