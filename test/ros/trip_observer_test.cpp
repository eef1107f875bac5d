// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/ros/trip_observer.h"

#include <gtest/gtest.h>

namespace pomdp_crowd_nav {
namespace {

World emptyField() {
  World world;
  world.bounds = {Point(0.0, 0.0), Point(100.0, 100.0)};
  world.start = {Point(10.0, 10.0), 0.0};
  world.goal = Point(90.0, 90.0);
  world.destinations = {Point(0.0, 0.0), Point(100.0, 100.0)};
  return world;
}

TEST(TripObserver, RobotThatIsPutElsewhereHasNotDrivenThere) {
  Simulator::Params params;
  params.pedestrians = 0;
  Simulator simulator(emptyField(), params);
  TripObserver observer({}, Point(90.0, 90.0));
  observer.begin(Point(90.0, 90.0), 0.0);
  const auto drive = [&] {
    for (int i = 0; i < 10; ++i) {
      simulator.setCommand({Point(1.0, 0.0), 0.0});
      simulator.advance(Crowd::kTick);
      observer.tick(simulator);
    }
  };
  drive();
  const double driven = observer.metrics().path_length;
  EXPECT_GT(driven, 0.5);
  simulator.placeRobot({Point(50.0, 50.0), 0.0});
  observer.jump();
  drive();
  EXPECT_NEAR(observer.metrics().path_length, 2.0 * driven, 0.2);
}

}  // namespace
}  // namespace pomdp_crowd_nav
