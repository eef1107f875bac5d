// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/ros/trip_planner.h"

#include <gtest/gtest.h>

#include <chrono>
#include <stdexcept>
#include <thread>

namespace pomdp_crowd_nav {
namespace {

// An obstacle between start and goal.
std::shared_ptr<const StaticMap> map() {
  StaticMap::Obstacles obstacles;
  obstacles.circles = {{Point(20.0, 20.0), 4.0}};
  return std::make_shared<const StaticMap>(Bounds{Point(0.0, 0.0), Point(40.0, 40.0)}, obstacles);
}

NavigationParams params() {
  NavigationParams params;
  params.planning.model.step = 0.5;
  params.planning.prior.resolution = 0.5;
  params.planning.search.scenarios = 20;
  return params;
}

class TripPlannerTest : public testing::Test {
 protected:
  TripPlannerTest() {
    planner_.start(Point(36.0, 20.0), map_, std::make_shared<const NavigationParams>(params()));
  }

  // Whether another planner took over.
  bool follow(const NavigationParams& changed) {
    const auto shared = std::make_shared<const NavigationParams>(changed);
    for (int i = 0; i < 1000; ++i) {
      if (planner_.follow(shared)) return true;
      if (&planner_.params() == shared.get()) return false;
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    ADD_FAILURE() << "the planner does not follow";
    return false;
  }

  double clearance() const {
    double least = 1e9;
    for (const Point& point : planner_.planner().globalPath(Point(4.0, 20.0))) {
      least = std::min(least, map_->clearance(point));
    }
    return least;
  }

  double upperBound() const {
    Situation situation;
    situation.vehicle.position = Point(4.0, 20.0);
    return planner_.planner().decide(situation, SearchLimit::trials(5)).search.upper_bound;
  }

  std::shared_ptr<const StaticMap> map_ = map();
  TripPlanner planner_{{Point(0.0, 0.0), Point(40.0, 40.0)}};
};

TEST_F(TripPlannerTest, FollowsWeights) {
  NavigationParams changed = params();
  changed.planning.model.reward.goal = 50.0;
  ASSERT_GT(upperBound(), 100.0);
  const Planner* before = &planner_.planner();
  const double clearance_before = clearance();
  EXPECT_TRUE(follow(changed));
  EXPECT_NE(&planner_.planner(), before);
  EXPECT_LE(upperBound(), 50.0);
  EXPECT_EQ(clearance(), clearance_before);
}

TEST_F(TripPlannerTest, FollowsDistances) {
  NavigationParams changed = params();
  changed.planning.model.obstacle_distance = 5.0;
  EXPECT_NEAR(clearance(), 3.3, 0.5);
  EXPECT_TRUE(follow(changed));
  EXPECT_NEAR(clearance(), 6.3, 0.5);
  changed.planning.model.reward.time = -2.0;
  EXPECT_TRUE(follow(changed));
  EXPECT_NEAR(clearance(), 6.3, 0.5) << "the tables of the distance before last";
}

TEST_F(TripPlannerTest, KeepsThePlannerWhereTheChangeIsNotItsBusiness) {
  NavigationParams changed = params();
  changed.search_time = 0.2;
  changed.emergency.reflex_distance = 1.0;
  const Planner* before = &planner_.planner();
  EXPECT_FALSE(follow(changed));
  EXPECT_EQ(&planner_.planner(), before);
  EXPECT_EQ(planner_.params().search_time, 0.2);
}

TEST_F(TripPlannerTest, TheNewestOfSeveralChangesHolds) {
  NavigationParams changed = params();
  changed.planning.model.reward.goal = 500.0;
  planner_.follow(std::make_shared<const NavigationParams>(changed));
  changed.planning.model.reward.goal = 60.0;
  EXPECT_TRUE(follow(changed)) << "the first";
  EXPECT_EQ(planner_.params().planning.model.reward.goal, 500.0);
  EXPECT_TRUE(follow(changed)) << "the second";
  EXPECT_LE(upperBound(), 60.0);
}

TEST_F(TripPlannerTest, AnotherTripDropsAPlannerThatIsBeingMade) {
  NavigationParams changed = params();
  changed.planning.model.reward.goal = 50.0;
  planner_.follow(std::make_shared<const NavigationParams>(changed));
  planner_.start(Point(20.0, 36.0), map_, std::make_shared<const NavigationParams>(params()));
  EXPECT_GT(upperBound(), 100.0);
  EXPECT_THROW(
      planner_.start(Point(20.0, 20.0), map_, std::make_shared<const NavigationParams>(params())),
      std::invalid_argument);
  EXPECT_FALSE(planner_.isReady());
}

}  // namespace
}  // namespace pomdp_crowd_nav
