// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/planner/extended_space_planner.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace pomdp_crowd_nav {
namespace {

const std::vector<Point> kCorners{{0.0, 0.0}, {0.0, 30.0}, {40.0, 30.0}, {40.0, 0.0}};

PlannerParams testParams() {
  PlannerParams params;
  params.search.scenarios = 50;
  params.model.horizon = 40.0;
  return params;
}

std::unique_ptr<Planner> makeOn(const StaticMap& map, const PlannerParams& params = testParams()) {
  return makePlanner("2d_fmm", {map, {36.0, 15.0}, kCorners}, params);
}

StaticMap openField() { return StaticMap({{0.0, 0.0}, {40.0, 30.0}}, {}); }

PersonBelief standing(std::int64_t id, const Point& position) {
  return {id, position, {0.0, 0.0}, 0.0, IntentionBelief(4)};
}

TEST(ExtendedSpacePlanner, AloneItFollowsThePriorAtFullSpeed) {
  const StaticMap map = openField();
  const auto planner = makeOn(map);
  const VehicleState at_rest{{5.0, 15.0}, 1.0, 0.0};
  const Decision start = planner->decide({at_rest, {}}, SearchLimit::trials(50));
  EXPECT_EQ(start.action, Action::followPrior(1));
  const VehicleState cruising{{5.0, 15.0}, 0.0, 2.0};
  const Decision on = planner->decide({cruising, {}}, SearchLimit::trials(50));
  EXPECT_NEAR(on.motion.end().position.x(), 7.0, 0.01);
  EXPECT_NEAR(on.motion.end().position.y(), 15.0, 0.1);
}

TEST(ExtendedSpacePlanner, ActionsComeFromThePapersSet) {
  const StaticMap map = openField();
  const auto planner = makeOn(map);
  const ActionSets sets;
  for (const double speed : {0.0, 1.0, 2.0}) {
    for (double y = 10.0; y < 20.0; y += 1.0) {
      const Decision decision = planner->decide(
          {{{10.0, y}, 0.5, speed}, {0.0, {standing(1, {14.0, y})}}}, SearchLimit::trials(20));
      const auto& legal = sets.legal(speed > 0.0, true).actions;
      EXPECT_NE(std::find(legal.begin(), legal.end(), decision.action), legal.end())
          << describe(decision.action);
    }
  }
}

TEST(ExtendedSpacePlanner, GoesRoundAnObstacle) {
  StaticMap::Obstacles obstacles;
  obstacles.circles = {{{20.0, 15.0}, 4.0}};
  const StaticMap map({{0.0, 0.0}, {40.0, 30.0}}, obstacles);
  const auto planner = makeOn(map);
  VehicleState robot{{5.0, 15.0}, 0.0, 0.0};
  for (int step = 0; (robot.position - Point(36.0, 15.0)).norm() > 1.0; ++step) {
    ASSERT_LT(step, 40);
    robot = planner->decide({robot, {}}, SearchLimit::trials(15)).motion.end();
    EXPECT_GT(map.clearance(robot.position), 2.9);
  }
}

// Somebody stands in the way: the robot goes round, at speed, and never within 2 m.
TEST(ExtendedSpacePlanner, GoesRoundAPersonWhoStands) {
  const StaticMap map = openField();
  const auto planner = makeOn(map);
  const Point person(15.0, 15.0);
  const CrowdBelief crowd{0.0, {standing(1, person)}};
  VehicleState robot{{5.0, 15.0}, 0.0, 0.0};
  int steps = 0;
  for (; (robot.position - Point(36.0, 15.0)).norm() > 1.0; ++steps) {
    ASSERT_LT(steps, 60);
    const Decision decision = planner->decide({robot, crowd}, SearchLimit::trials(60));
    for (const double t : {0.0, 0.5, 1.0}) {
      EXPECT_GT((decision.motion.positionAt(t) - person).norm(), 2.0);
    }
    robot = decision.motion.end();
  }
  EXPECT_LT(steps, 24) << "20 steps on an empty field";
}

TEST(ExtendedSpacePlanner, AStepAlongThePriorEndsOnTheGoal) {
  const StaticMap map = openField();
  const auto planner = makeOn(map);
  const VehicleState robot{{34.6, 15.0}, 0.0, 2.0};
  const Decision decision = planner->decide({robot, {}}, SearchLimit::trials(50));
  EXPECT_LE((decision.motion.end().position - Point(36.0, 15.0)).norm(), 1.0);
}

TEST(ExtendedSpacePlanner, AttendsToTheNearest) {
  const StaticMap map = openField();
  PlannerParams params = testParams();
  params.pedestrians = 2;
  const auto planner = makeOn(map, params);
  const CrowdBelief crowd{
      0.0, {standing(3, {30.0, 15.0}), standing(5, {9.0, 15.0}), standing(8, {5.0, 19.0})}};
  const Decision decision =
      planner->decide({{{5.0, 15.0}, 0.0, 0.0}, crowd}, SearchLimit::trials(5));
  EXPECT_EQ(decision.attended, (std::vector<std::int64_t>{5, 8}));
}

// The seed is of the sampled futures.
TEST(ExtendedSpacePlanner, AnotherSeedSamplesOtherFutures) {
  const StaticMap map = openField();
  PlannerParams params = testParams();
  const CrowdBelief crowd{0.0, {{1, {12.0, 16.0}, {0.0, 0.0}, 1.0, IntentionBelief(4)}}};
  const Situation situation{{{5.0, 15.0}, 0.0, 1.0}, crowd};
  const Decision first = makeOn(map, params)->decide(situation, SearchLimit::trials(20));
  params.seed = 2;
  const Decision second = makeOn(map, params)->decide(situation, SearchLimit::trials(20));
  EXPECT_NE(first.search.initial_lower_bound, second.search.initial_lower_bound);
}

}  // namespace
}  // namespace pomdp_crowd_nav
