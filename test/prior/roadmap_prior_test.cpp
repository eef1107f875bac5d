// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/prior/roadmap_prior.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

#include "pomdp_crowd_nav/prior/fast_marching_prior.h"
#include "pomdp_crowd_nav/sim/world_file.h"

namespace pomdp_crowd_nav {
namespace {

constexpr double kStep = 0.1;  // [m]

struct Walk {
  bool arrived = false;
  double length = 0.0;                                               // [m]
  double least_clearance = std::numeric_limits<double>::infinity();  // [m]
};

Walk follow(const RolloutPrior& prior, const StaticMap& map, Point place) {
  Walk walk;
  while (!walk.arrived && walk.length < 400.0) {
    walk.least_clearance = std::min(walk.least_clearance, map.clearance(place));
    const auto direction = prior.directionAt({place, 0.0});
    if (!direction) break;
    place += kStep * unitVector(*direction);
    walk.length += kStep;
    walk.arrived = (place - prior.goal()).norm() <= kStep;
  }
  return walk;
}

class RoadmapPriorOnWorlds : public testing::TestWithParam<const char*> {};

TEST_P(RoadmapPriorOnWorlds, LeadsToTheGoalOnPathsAsShortAsThoseOfFastMarching) {
  const World world = loadWorld(std::string(SOURCE_DIR "/config/worlds/") + GetParam() + ".yaml");
  const StaticMap map = world.map();
  const PriorParams params;
  const RoadmapPrior prior(map, world.goal, params);
  const FastMarchingPrior fast_marching(map, world.goal, params);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> x(0.0, 100.0), y(0.0, 100.0);
  double ratio = 0.0;
  int count = 0;
  while (count < 300) {
    const Point start(x(random), y(random));
    const double shortest = fast_marching.distanceToGoal(start);
    const bool in_the_pocket = start.x() > 65.0 && start.y() < 40.0;  // of scenario_3
    if (map.clearance(start) < 3.3 || shortest < 2.0) continue;
    if (in_the_pocket && !prior.directionAt({start, 0.0})) continue;
    const Walk walk = follow(prior, map, start);
    ASSERT_TRUE(walk.arrived) << "from " << start.transpose();
    EXPECT_GE(walk.least_clearance, 3.299) << "from " << start.transpose();
    EXPECT_LE(walk.length, prior.distanceToGoal(start) + 2.0 * kStep);
    EXPECT_LE(walk.length, 1.15 * shortest) << "from " << start.transpose();
    ratio += walk.length / shortest;
    ++count;
  }
  EXPECT_LE(ratio / count, 1.02);
}

INSTANTIATE_TEST_SUITE_P(Scenarios, RoadmapPriorOnWorlds,
                         testing::Values("scenario_1", "scenario_2", "scenario_3"),
                         [](const auto& test) { return test.param; });

StaticMap discMap() {
  StaticMap::Obstacles obstacles;
  obstacles.circles = {{{20.0, 15.0}, 4.0}};
  return StaticMap({{0.0, 0.0}, {40.0, 30.0}}, obstacles);
}

PriorParams smallParams() {
  PriorParams params;
  params.clearance = 1.5;
  params.milestones = 300;
  params.milestone_spacing = 0.5;
  return params;
}

TEST(RoadmapPriorTest, ANewGoalOnTheSameMapHasTheSameRoadmap) {
  const RoadmapPrior first(discMap(), {38.0, 15.0}, smallParams());
  const RoadmapPrior second(discMap(), {3.0, 25.0}, smallParams());
  EXPECT_EQ(first.roadmap(), second.roadmap());
  PriorParams other = smallParams();
  other.seed = 12;
  EXPECT_NE(RoadmapPrior(discMap(), {3.0, 25.0}, other).roadmap(), first.roadmap());
}

TEST(RoadmapPriorTest, LeadsOutOfAnObstacleTheShortWay) {
  const StaticMap map = discMap();
  const RoadmapPrior prior(map, {38.0, 15.0}, smallParams());
  Point place(16.5, 15.3);  // on the far side from the goal
  int steps = 0;
  for (; map.clearance(place) < 1.8 - LineOfSight::kShortfall; ++steps) {
    ASSERT_LT(steps, 50);
    place += kStep * unitVector(*prior.directionAt({place, 0.0}));
  }
  EXPECT_LT(steps, 40) << "2.3 m to the edge of the margin";
  EXPECT_TRUE(follow(prior, map, place).arrived);
}

TEST(RoadmapPriorTest, LeadsToAGoalInsideTheClearance) {
  const StaticMap map = discMap();
  const RoadmapPrior prior(map, {25.0, 15.0}, smallParams());  // 1 m from the disc
  for (const Point& start : {Point(35.0, 15.0), Point(3.0, 15.0), Point(20.0, 25.0)}) {
    const Walk walk = follow(prior, map, start);
    EXPECT_TRUE(walk.arrived) << "from " << start.transpose();
    EXPECT_GT(walk.least_clearance, 0.9) << "from " << start.transpose();
  }
}

TEST(RoadmapPriorTest, KnowsNoWayFromOffTheMapAndFromBehindAWall) {
  StaticMap::Obstacles obstacles;
  obstacles.polygons = {{{{20.0, 0.0}, {20.0, 30.0}}, false}};
  const RoadmapPrior prior(StaticMap({{0.0, 0.0}, {40.0, 30.0}}, obstacles), {38.0, 15.0},
                           smallParams());
  for (const Point& place :
       {Point(5.0, 5.0), Point(19.5, 5.0), Point(41.0, 5.0), Point(std::nan(""), 5.0)}) {
    EXPECT_FALSE(prior.directionAt({place, 0.0})) << place.transpose();
    EXPECT_TRUE(std::isinf(prior.distanceToGoal(place))) << place.transpose();
  }
  EXPECT_TRUE(prior.directionAt({{20.5, 5.0}, 0.0}));
}

}  // namespace
}  // namespace pomdp_crowd_nav
