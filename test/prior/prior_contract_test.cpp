// SPDX-License-Identifier: BSD-3-Clause
// What every roll-out prior must do, run over every name in the table.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "pomdp_crowd_nav/prior/prior_factory.h"

namespace pomdp_crowd_nav {
namespace {

constexpr double kStep = 0.1;  // [m]

StaticMap emptyMap() { return StaticMap(Bounds{{0.0, 0.0}, {40.0, 30.0}}, {}); }

StaticMap mapWithDiscs() {
  StaticMap::Obstacles obstacles;
  obstacles.circles = {{{12.0, 15.0}, 2.0}, {{26.0, 10.0}, 3.0}, {{26.0, 23.0}, 2.0}};
  return StaticMap(Bounds{{0.0, 0.0}, {40.0, 30.0}}, obstacles);
}

struct Walk {
  bool arrived = false;
  double length = 0.0;                                               // [m]
  double least_clearance = std::numeric_limits<double>::infinity();  // [m]
  double largest_rise = 0.0;  // [m], of the distance to the goal over a step
};

Walk follow(const RolloutPrior& prior, const StaticMap& map, const Point& start) {
  Walk walk;
  Pose pose{start, 0.0};
  while (walk.length < 200.0) {
    walk.least_clearance = std::min(walk.least_clearance, map.clearance(pose.position));
    walk.arrived = (pose.position - prior.goal()).norm() <= kStep;
    if (walk.arrived) break;
    const auto direction = prior.directionAt(pose);
    if (!direction) break;
    const double before = prior.distanceToGoal(pose.position);
    pose = {pose.position + kStep * unitVector(*direction), *direction};
    walk.length += kStep;
    walk.largest_rise = std::max(walk.largest_rise, prior.distanceToGoal(pose.position) - before);
  }
  return walk;
}

// Starts that keep `clearance`, among them the border and places straight behind an obstacle.
std::vector<Point> starts(const StaticMap& map, double clearance) {
  std::vector<Point> found;
  for (double x = 0.0; x <= 40.0; x += 2.5) {
    for (double y = 0.0; y <= 30.0; y += 2.5) {
      if (map.clearance({x, y}) >= clearance) found.emplace_back(x, y);
    }
  }
  return found;
}

PriorParams testParams() {
  PriorParams params;
  params.clearance = 1.5;
  params.milestone_spacing = 0.5;  // these maps are small
  return params;
}

std::string rejection(const std::string& name, const StaticMap& map, const Point& goal) {
  try {
    makePrior(name, map, goal, testParams());
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "accepted";
}

class PriorContract : public testing::TestWithParam<std::string> {};

TEST_P(PriorContract, LeadsToTheGoalOnAnEmptyMap) {
  const StaticMap map = emptyMap();
  for (const Point& goal : {Point(31.0, 17.0), Point(40.0, 22.5), Point(0.0, 0.0)}) {
    const auto prior = makePrior(GetParam(), map, goal, testParams());
    EXPECT_EQ(prior->goal(), goal);
    for (const Point& start : starts(map, 0.0)) {
      const double straight = (goal - start).norm();
      const Walk walk = follow(*prior, map, start);
      ASSERT_TRUE(walk.arrived) << "from " << start.transpose() << " to " << goal.transpose();
      EXPECT_LT(walk.length, straight * 1.005 + 2.0 * kStep) << "from " << start.transpose();
      EXPECT_LE(walk.largest_rise, 0.0) << "from " << start.transpose();
      EXPECT_NEAR(prior->distanceToGoal(start), straight, 0.02) << "from " << start.transpose();
    }
  }
}

TEST_P(PriorContract, LeadsToTheGoalAmongObstacles) {
  const StaticMap map = mapWithDiscs();
  const PriorParams params = testParams();
  const auto prior = makePrior(GetParam(), map, {38.0, 15.0}, params);
  // Where two fastest paths part, they take the same time but may be of two lengths.
  const bool is_shortest = GetParam() != "fast_marching_square";
  int count = 0;
  int surprises = 0;
  double promised = 0.0;
  double walked = 0.0;
  for (const Point& start : starts(map, params.clearance + params.extra_clearance)) {
    const Walk walk = follow(*prior, map, start);
    ASSERT_TRUE(walk.arrived) << "from " << start.transpose();
    const double distance = prior->distanceToGoal(start);
    const bool as_promised = walk.largest_rise <= 0.0 &&
                             std::abs(distance - walk.length) <= 0.02 * walk.length + 2.0 * kStep;
    EXPECT_TRUE(as_promised || !is_shortest)
        << "from " << start.transpose() << ": " << distance << " m, walked " << walk.length
        << " m, rise " << walk.largest_rise;
    surprises += as_promised ? 0 : 1;
    ++count;
    promised += distance;
    walked += walk.length;
    if (GetParam() == "straight_line") continue;  // the one that ignores the map
    EXPECT_GE(walk.least_clearance, params.clearance) << "from " << start.transpose();
  }
  EXPECT_LT(surprises, count / 10);
  EXPECT_NEAR(promised, walked, 0.01 * walked);
}

// Tables of the whole map ask this way. Off the map, inside obstacles and on the goal, too.
TEST_P(PriorContract, SaysAtOnceWhatItSaysOneByOne) {
  const StaticMap map = mapWithDiscs();
  const Point goal(38.0, 15.0);
  const auto prior = makePrior(GetParam(), map, goal, testParams());
  std::vector<Point> places{goal, goal + Point(0.01, 0.0), Point(-3.0, 5.0), Point(50.0, 40.0)};
  for (const Point& start : starts(map, -10.0)) places.push_back(start + Point(0.03, 0.07));
  for (const Point& place : places) {
    const Course course = prior->courseAt({place, 0.4});
    const auto direction = prior->directionAt({place, 0.4});
    const Point expected = direction ? unitVector(*direction) : Point(0.0, 0.0);
    EXPECT_NEAR((course.direction - expected).norm(), 0.0, 1e-12) << place.transpose();
    EXPECT_EQ(course.distance, prior->distanceToGoal(place)) << place.transpose();
  }
}

TEST_P(PriorContract, AnswersTheSameToManyThreads) {
  const StaticMap map = mapWithDiscs();
  const auto prior = makePrior(GetParam(), map, {38.0, 15.0}, testParams());
  const std::vector<Point> places = starts(map, 0.0);
  const auto answers = [&] {
    std::vector<double> found;
    for (const Point& place : places) {
      found.push_back(prior->directionAt({place, 0.0}).value_or(-10.0));
      found.push_back(prior->distanceToGoal(place));
    }
    return found;
  };
  const std::vector<double> expected = answers();
  std::vector<std::vector<double>> found(4);
  std::vector<std::thread> threads;
  for (auto& mine : found) {
    threads.emplace_back([&] {
      for (int i = 0; i < 20; ++i) mine = answers();
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (const auto& mine : found) EXPECT_EQ(mine, expected);
}

TEST_P(PriorContract, RejectsAGoalOffTheMapOrInsideAnObstacle) {
  const StaticMap map = mapWithDiscs();
  EXPECT_EQ(rejection(GetParam(), map, {40.5, 10.5}), "goal (40.5, 10.5) is off the map");
  EXPECT_EQ(rejection(GetParam(), map, {26.5, 10.5}), "goal (26.5, 10.5) is inside an obstacle");
  EXPECT_NE(rejection(GetParam(), map, {std::nan(""), 1.0}), "accepted");
  EXPECT_EQ(rejection(GetParam(), map, {40.0, 30.0}), "accepted");
}

INSTANTIATE_TEST_SUITE_P(EveryName, PriorContract, testing::ValuesIn(priorNames()),
                         [](const auto& test) { return test.param; });

TEST(PriorFactoryTest, UnknownNameIsRejectedWithTheKnownOnes) {
  const std::string reason = rejection("teleport", emptyMap(), {1.0, 1.0});
  EXPECT_NE(reason.find("teleport"), std::string::npos) << reason;
  ASSERT_GE(priorNames().size(), 2U);
  for (const std::string& name : priorNames()) {
    EXPECT_NE(reason.find(name), std::string::npos) << reason;
  }
}

}  // namespace
}  // namespace pomdp_crowd_nav
