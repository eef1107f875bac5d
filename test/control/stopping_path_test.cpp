// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/control/stopping_path.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace pomdp_crowd_nav {
namespace {

constexpr StoppingPath::Params kParams{0.6, 0.2};  // 0.6 m, 0.2 s

VehicleParams rampedBase() {
  VehicleParams vehicle;
  vehicle.max_speed = 1.0;
  vehicle.brake_deceleration = 1.0;
  vehicle.instant_velocity = false;
  return vehicle;
}

VehicleState drivingEast(double speed) { return {{10.0, 5.0}, 0.0, speed}; }

bool isBlocked(const VehicleState& robot, const Point& person, const Point& velocity = {0.0, 0.0}) {
  const StoppingPath path(kParams, rampedBase());
  return path.blockedBy(robot, 0.0, {{7, person, velocity}}).has_value();
}

// 1 m/s: 0.2 m of reaction and 0.5 m of braking.
TEST(StoppingPath, ReachesAsFarAsTheRobotNeedsToRest) {
  const StoppingPath path(kParams, rampedBase());
  EXPECT_NEAR(path.length(1.0), 0.7, 1e-12);
  EXPECT_NEAR(path.duration(1.0), 1.2, 1e-12);
  EXPECT_TRUE(isBlocked(drivingEast(1.0), {10.0 + 0.7 + 0.59, 5.0}));
  EXPECT_FALSE(isBlocked(drivingEast(1.0), {10.0 + 0.7 + 0.61, 5.0}));
  EXPECT_FALSE(isBlocked(drivingEast(0.5), {10.0 + 0.7 + 0.59, 5.0}));
}

TEST(StoppingPath, AnInstantBaseNeedsItsReactionOnly) {
  VehicleParams vehicle;
  vehicle.instant_velocity = true;
  const StoppingPath path(kParams, vehicle);
  EXPECT_NEAR(path.length(2.0), 0.4, 1e-12);
  EXPECT_TRUE(path.blockedBy(drivingEast(2.0), 0.0, {{7, {10.99, 5.0}, {0.0, 0.0}}}));
  EXPECT_FALSE(path.blockedBy(drivingEast(2.0), 0.0, {{7, {11.01, 5.0}, {0.0, 0.0}}}));
}

TEST(StoppingPath, NamesThePersonInTheWay) {
  const StoppingPath path(kParams, rampedBase());
  const std::vector<Track> people = {{3, {10.0, 9.0}, {0.0, 0.0}}, {8, {11.0, 5.2}, {0.0, 0.0}}};
  EXPECT_EQ(path.blockedBy(drivingEast(1.0), 0.0, people).value_or(-1), 8);
}

TEST(StoppingPath, WhoIsBesideOrBehindIsNotInTheWay) {
  EXPECT_FALSE(isBlocked(drivingEast(1.0), {10.5, 5.65}));
  EXPECT_TRUE(isBlocked(drivingEast(1.0), {10.7, 5.55}));
  EXPECT_FALSE(isBlocked(drivingEast(1.0), {9.5, 5.0})) << "the robot may drive away";
  EXPECT_FALSE(isBlocked(drivingEast(1.0), {9.0, 5.0}, {1.5, 0.0})) << "who runs after it";
}

TEST(StoppingPath, PeopleAreWhereTheyWillBe) {
  EXPECT_TRUE(isBlocked(drivingEast(1.0), {11.8, 5.0}, {-1.0, 0.0})) << "comes up";
  EXPECT_FALSE(isBlocked(drivingEast(1.0), {11.0, 5.0}, {1.5, 0.0})) << "goes ahead, faster";
  EXPECT_TRUE(isBlocked(drivingEast(1.0), {11.0, 6.2}, {0.0, -1.0})) << "steps into the way";
  EXPECT_FALSE(isBlocked(drivingEast(1.0), {11.0, 6.2}, {0.0, 1.0}));
}

TEST(StoppingPath, WhoComesUpToARobotAtRestIsNoReason) {
  EXPECT_FALSE(isBlocked(drivingEast(0.0), {10.7, 5.0}, {-2.0, 0.0}));
}

TEST(StoppingPath, ImpossibleSpeedsOfPeopleAreCut) {
  EXPECT_FALSE(isBlocked(drivingEast(0.2), {60.0, 5.0}, {-1e6, 0.0}));
  EXPECT_TRUE(isBlocked(drivingEast(0.2), {11.0, 5.0}, {-1e300, -0.0}));
}

TEST(StoppingPath, FollowsTheArcOfACar) {
  const StoppingPath path({0.3, 0.5}, rampedBase());
  const VehicleState robot = drivingEast(1.0);  // drives 1 m, to the left on a circle of 1 m
  const Point on_arc = robot.position + Point(std::sin(0.9), 1.0 - std::cos(0.9));
  const Point straight_on = robot.position + Point(0.95, 0.0);
  EXPECT_TRUE(path.blockedBy(robot, 1.0, {{7, on_arc, {0.0, 0.0}}}));
  EXPECT_FALSE(path.blockedBy(robot, 0.0, {{7, on_arc, {0.0, 0.0}}}));
  EXPECT_FALSE(path.blockedBy(robot, 1.0, {{7, straight_on, {0.0, 0.0}}}));
}

TEST(StoppingPath, RefusesADistanceThatIsNone) {
  EXPECT_THROW(StoppingPath({0.0, 0.2}, rampedBase()), std::invalid_argument);
  EXPECT_THROW(StoppingPath({0.6, -0.2}, rampedBase()), std::invalid_argument);
}

}  // namespace
}  // namespace pomdp_crowd_nav
