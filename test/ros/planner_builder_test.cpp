// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/ros/planner_builder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <thread>
#include <vector>

namespace pomdp_crowd_nav {
namespace {

using MapPointer = std::shared_ptr<const StaticMap>;

NavigationParams testParams() {
  NavigationParams params;
  params.planning.model.vehicle.radius = 0.5;
  params.planning.model.obstacle_distance = 0.4;
  params.planning.search.scenarios = 20;
  return params;
}

MapPointer mapWith(const std::vector<Circle>& circles) {
  StaticMap::Obstacles obstacles;
  obstacles.circles = circles;
  return std::make_shared<const StaticMap>(Bounds{Point(0.0, 0.0), Point(20.0, 20.0)}, obstacles);
}

MapPointer mapWithWall() {
  StaticMap::Obstacles obstacles;
  obstacles.polygons.push_back({{Point(10.0, 0.0), Point(10.0, 20.0)}, false});
  return std::make_shared<const StaticMap>(Bounds{Point(0.0, 0.0), Point(20.0, 20.0)}, obstacles);
}

class PlannerBuilderTest : public testing::Test {
 protected:
  PlannerBuilderTest()
      : drive_(Drive(MotionExecutor(CommandGenerator::Params(), VehicleParams(), 0.05))),
        work_(0.2),
        failures_(std::vector<std::string>()),
        builder_({Point(0.0, 0.0), Point(20.0, 20.0)}, drive_, work_,
                 [this](const Goal& goal, const std::string& reason) {
                   failures_.with([&](auto& failures) {
                     failures.push_back(std::to_string(goal.number) + " " + reason);
                   });
                   drive_.with([](Drive& drive) { drive.goal = Goal(); });
                 }) {
    set(testParams());
    drive_.with([](Drive& drive) {
      drive.inputs.robot = RobotReading();
      drive.inputs.robot->pose.position = Point(3.0, 10.0);
    });
  }

  void use(const MapPointer& map) {
    drive_.with([&](Drive& drive) { drive.inputs.map = map; });
  }
  void set(const NavigationParams& params) {
    drive_.with([shared = std::make_shared<const NavigationParams>(params)](Drive& drive) {
      drive.params = shared;
    });
  }
  void send(long number, const Point& goal) {
    drive_.with([&](Drive& drive) { drive.goal = Goal{number, Pose{goal, 0.0}}; });
  }
  static bool wait(const std::function<bool()>& condition) {
    for (int i = 0; i < 1000; ++i) {
      if (condition()) return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return false;
  }
  std::optional<ReadyPlanner> waitForPlanner() {
    std::optional<ReadyPlanner> ready;
    wait([&] { return (ready = builder_.take()).has_value(); });
    return ready;
  }
  std::vector<std::string> failures() {
    return failures_.with([](auto& failures) { return failures; });
  }

  Guarded<Drive> drive_;
  MapWork work_;
  Guarded<std::vector<std::string>> failures_;
  PlannerBuilder builder_;
};

TEST_F(PlannerBuilderTest, MakesOnePlannerForAGoalAndAMap) {
  const MapPointer map = mapWith({});
  send(1, {17.0, 10.0});
  use(map);
  const std::optional<ReadyPlanner> ready = waitForPlanner();
  ASSERT_TRUE(ready);
  EXPECT_EQ(ready->goal.number, 1);
  EXPECT_EQ(ready->map, map);
  EXPECT_EQ(ready->planner->globalPath({3.0, 10.0}).back(), Point(17.0, 10.0));
  std::this_thread::sleep_for(std::chrono::milliseconds(200));
  EXPECT_FALSE(builder_.take()) << "nothing has changed since";
}

TEST_F(PlannerBuilderTest, AnotherGoalOrMapIsAnotherPlanner) {
  use(mapWith({}));
  send(1, {17.0, 10.0});
  ASSERT_TRUE(waitForPlanner());
  send(2, {17.0, 12.0});
  std::optional<ReadyPlanner> ready = waitForPlanner();
  ASSERT_TRUE(ready);
  EXPECT_EQ(ready->goal.number, 2);
  const MapPointer newer = mapWith({{Point(10.0, 10.0), 2.0}});
  use(newer);
  ready = waitForPlanner();
  ASSERT_TRUE(ready);
  EXPECT_EQ(ready->map, newer);
  EXPECT_GT(ready->planner->guidanceAt({3.0, 10.0}).distance_to_goal, 14.2F) << "round the disc";
  EXPECT_TRUE(failures().empty());
}

double clearance(const ReadyPlanner& ready) {
  double least = 1e9;
  for (const Point& point : ready.planner->globalPath({3.0, 10.0})) {
    least = std::min(least, ready.map->clearance(point));
  }
  return least;
}

double upperBound(const ReadyPlanner& ready) {
  Situation situation;
  situation.vehicle.position = Point(3.0, 10.0);
  return ready.planner->decide(situation, SearchLimit::trials(5)).search.upper_bound;
}

TEST_F(PlannerBuilderTest, FollowsWeights) {
  use(mapWith({{Point(10.0, 10.0), 2.0}}));
  send(1, {17.0, 10.0});
  const std::optional<ReadyPlanner> before = waitForPlanner();
  ASSERT_TRUE(before);
  ASSERT_GT(upperBound(*before), 100.0);
  NavigationParams changed = testParams();
  changed.planning.model.reward.goal = 50.0;
  set(changed);
  const std::optional<ReadyPlanner> after = waitForPlanner();
  ASSERT_TRUE(after);
  EXPECT_LE(upperBound(*after), 50.0);
  EXPECT_EQ(clearance(*after), clearance(*before));
}

TEST_F(PlannerBuilderTest, FollowsDistances) {
  use(mapWith({{Point(10.0, 10.0), 2.0}}));
  send(1, {17.0, 10.0});
  const std::optional<ReadyPlanner> before = waitForPlanner();
  ASSERT_TRUE(before);
  EXPECT_NEAR(clearance(*before), 1.2, 0.3);
  NavigationParams changed = testParams();
  changed.planning.model.obstacle_distance = 2.0;
  set(changed);
  std::optional<ReadyPlanner> after = waitForPlanner();
  ASSERT_TRUE(after);
  EXPECT_NEAR(clearance(*after), 2.8, 0.3);
  changed.planning.model.reward.time = -2.0;
  set(changed);
  after = waitForPlanner();
  ASSERT_TRUE(after);
  EXPECT_NEAR(clearance(*after), 2.8, 0.3) << "the tables of the distance before last";
}

TEST_F(PlannerBuilderTest, KeepsThePlannerWhereTheChangeIsNotItsBusiness) {
  use(mapWith({}));
  send(1, {17.0, 10.0});
  ASSERT_TRUE(waitForPlanner());
  NavigationParams changed = testParams();
  changed.search_time = 0.2;
  changed.emergency.reflex_distance = 1.0;
  set(changed);
  std::this_thread::sleep_for(std::chrono::milliseconds(200));
  EXPECT_FALSE(builder_.take());
  changed.planning.model.reward.goal = 50.0;
  set(changed);
  EXPECT_TRUE(waitForPlanner()) << "a later change is still seen";
}

TEST_F(PlannerBuilderTest, TheNewestOfSeveralChangesHolds) {
  use(mapWith({}));
  send(1, {17.0, 10.0});
  ASSERT_TRUE(waitForPlanner());
  NavigationParams changed = testParams();
  for (const double goal : {500.0, 400.0, 60.0}) {
    changed.planning.model.reward.goal = goal;
    set(changed);
  }
  std::optional<ReadyPlanner> last;
  EXPECT_TRUE(wait([&] {
    std::optional<ReadyPlanner> ready = builder_.take();
    if (ready) last = std::move(ready);
    return last && upperBound(*last) <= 60.0;
  }));
}

TEST_F(PlannerBuilderTest, GoalInAnObstacleOfANewMapFails) {
  use(mapWith({}));
  send(1, {17.0, 10.0});
  ASSERT_TRUE(waitForPlanner());
  use(mapWith({{Point(17.0, 10.0), 2.0}}));
  ASSERT_TRUE(wait([this] { return !failures().empty(); }));
  EXPECT_EQ(failures().front(), "1 failed: goal (17.00, 10.00) is inside an obstacle");
}

TEST_F(PlannerBuilderTest, GoalWithoutAWayFails) {
  use(mapWithWall());
  send(1, {17.0, 10.0});
  ASSERT_TRUE(wait([this] { return !failures().empty(); }));
  EXPECT_EQ(failures().front().find("1 no way to the goal (17.00, 10.00): an obstacle at"), 0u)
      << failures().front();
  EXPECT_FALSE(builder_.take());
}

TEST_F(PlannerBuilderTest, TheLastOfManyGoalsIsServed) {
  use(mapWithWall());
  for (int number = 1; number <= 50; ++number) {
    send(number, Point(5.0, 5.0 + 0.1 * number));
  }
  long last = 0;
  EXPECT_TRUE(wait([&] {
    const std::optional<ReadyPlanner> ready = builder_.take();
    if (ready) last = ready->goal.number;
    return last == 50;
  }));
  EXPECT_TRUE(failures().empty());
}

}  // namespace
}  // namespace pomdp_crowd_nav
