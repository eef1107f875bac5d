// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/sim/base.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace pomdp_crowd_nav {
namespace {

const double kNan = std::numeric_limits<double>::quiet_NaN();
const double kQuarterTurn = std::acos(0.0);

VehicleParams realBase() {
  VehicleParams params;
  params.instant_velocity = false;
  params.max_speed = 2.0;
  params.acceleration = 1.0;
  params.lateral_acceleration = 0.5;
  params.brake_deceleration = 4.0;
  params.max_yaw_rate = 1.0;
  params.yaw_acceleration = 2.0;
  return params;
}

SimulatedBase movingBase(const Point& velocity) {
  SimulatedBase base(realBase(), {});
  base.follow({velocity, 0.0}, 20.0);
  return base;
}

VehicleParams car() {
  VehicleParams params;
  params.kind = VehicleKind::kCar;
  params.max_speed = 4.0;
  params.max_yaw_rate = 3.2;
  return params;
}

TEST(SimulatedBase, ACarDrivesAnExactArc) {
  SimulatedBase base(car(), {{1.0, 2.0}, 0.3});
  base.follow({{2.0, 0.0}, 0.5}, 0.6);  // 0.3 rad on a circle of 4 m
  EXPECT_NEAR(base.pose().heading, 0.6, 1e-12);
  EXPECT_NEAR(base.pose().position.x(), 1.0 + 4.0 * (std::sin(0.6) - std::sin(0.3)), 1e-12);
  EXPECT_NEAR(base.pose().position.y(), 2.0 - 4.0 * (std::cos(0.6) - std::cos(0.3)), 1e-12);
  EXPECT_NEAR((base.velocity() - 2.0 * unitVector(0.6)).norm(), 0.0, 1e-12);
  EXPECT_DOUBLE_EQ(base.yawRate(), 0.5);
}

TEST(SimulatedBase, ACarGoesNeitherSidewaysNorBackwardsNorTurnsOnTheSpot) {
  SimulatedBase base(car(), {});
  base.follow({{0.0, 2.0}, 1.0}, 1.0);
  base.follow({{-1.0, 0.0}, 0.0}, 1.0);
  EXPECT_EQ(base.pose().position, Point(0.0, 0.0));
  EXPECT_EQ(base.pose().heading, 0.0);
  EXPECT_EQ(base.yawRate(), 0.0);
}

TEST(SimulatedBase, ACarTurnsNoTighterThanItsSteeringAllows) {
  SimulatedBase base(car(), {});
  base.follow({{1.0, 0.0}, 3.0}, 0.5);
  EXPECT_NEAR(base.pose().heading, 0.5 * std::tan(0.67), 1e-12);
  base.place({});
  base.follow({{9.0, 0.0}, -9.0}, 0.1);  // 4 m/s, and 3.2 rad/s at most; steering allows 3.17
  EXPECT_NEAR(base.yawRate(), -4.0 * std::tan(0.67), 1e-12);
}

TEST(SimulatedBase, ARampedCarBrakesOnItsCurve) {
  VehicleParams params = realBase();
  params.kind = VehicleKind::kCar;
  SimulatedBase base(params, {});
  base.follow({{2.0, 0.0}, 0.8}, 4.0);
  const double heading = base.pose().heading;
  base.follow({}, 1.0);  // 0.5 m to rest at 4 m/s^2
  EXPECT_NEAR(base.velocity().norm(), 0.0, 1e-12);
  EXPECT_NEAR(wrapAngle(base.pose().heading - heading), 0.5 * 0.4, 1e-3);
}

TEST(SimulatedBase, InstantBaseTakesAVelocityInItsBodyFrame) {
  SimulatedBase base(VehicleParams{}, {{1.0, 2.0}, kQuarterTurn});
  base.follow({{1.5, 0.0}, 0.5}, 0.4);  // facing y: 0.6 m up, 0.2 rad to the left
  EXPECT_NEAR(base.pose().position.x(), 1.0, 1e-12);
  EXPECT_NEAR(base.pose().position.y(), 2.6, 1e-12);
  EXPECT_NEAR(base.pose().heading, kQuarterTurn + 0.2, 1e-12);
  EXPECT_NEAR(base.velocity().y(), 1.5, 1e-12);
  EXPECT_DOUBLE_EQ(base.yawRate(), 0.5);
}

TEST(SimulatedBase, CapsSpeedAndYawRate) {
  SimulatedBase base(VehicleParams{}, {});  // 2 m/s, 1 rad/s
  base.follow({{3.0, 4.0}, -9.0}, 0.1);     // 5 m/s: direction (0.6, 0.8) kept
  EXPECT_NEAR(base.velocity().x(), 1.2, 1e-12);
  EXPECT_NEAR(base.velocity().y(), 1.6, 1e-12);
  EXPECT_DOUBLE_EQ(base.yawRate(), -1.0);
}

TEST(SimulatedBase, AcceleratesEachAxisAtItsOwnRate) {
  SimulatedBase base(realBase(), {});
  base.follow({{1.0, 1.0}, 0.0}, 0.5);
  EXPECT_NEAR(base.velocity().x(), 0.5, 1e-9);
  EXPECT_NEAR(base.velocity().y(), 0.25, 1e-9);
  // From rest: x = a t^2 / 2 = 1 * 0.25 / 2, y = 0.5 * 0.25 / 2.
  EXPECT_NEAR(base.pose().position.x(), 0.125, 1e-9);
  EXPECT_NEAR(base.pose().position.y(), 0.0625, 1e-9);
}

TEST(SimulatedBase, AxesAreThoseOfTheBody) {
  SimulatedBase base(realBase(), {{0.0, 0.0}, kQuarterTurn});
  base.follow({{1.0, 0.0}, 0.0}, 0.5);  // forward is along y of the planning frame
  EXPECT_NEAR(base.velocity().x(), 0.0, 1e-9);
  EXPECT_NEAR(base.velocity().y(), 0.5, 1e-9);
}

TEST(SimulatedBase, BrakesHarderThanItAccelerates) {
  SimulatedBase base = movingBase({1.6, 0.0});
  const double start = base.pose().position.x();
  base.follow({}, 0.2);  // 1.6 - 4 * 0.2
  EXPECT_NEAR(base.velocity().x(), 0.8, 1e-9);
  base.follow({}, 1.0);  // at rest after 0.4 s and v^2 / (2 b) = 0.32 m
  EXPECT_DOUBLE_EQ(base.velocity().norm(), 0.0);
  EXPECT_NEAR(base.pose().position.x() - start, 0.32, 1e-9);
}

TEST(SimulatedBase, ReversesThroughRest) {
  // 0.8 m/s forward to backward: 0.2 s of braking, then 0.3 s of acceleration.
  SimulatedBase base = movingBase({0.8, 0.0});
  base.follow({{-1.0, 0.0}, 0.0}, 0.5);
  EXPECT_NEAR(base.velocity().x(), -0.3, 1e-9);
}

TEST(SimulatedBase, NeverExceedsTheSpeedLimitInATurn) {
  SimulatedBase base = movingBase({2.0, 0.0});
  for (int i = 0; i < 200; ++i) {
    base.follow({{0.0, 2.0}, 1.0}, 0.05);
    ASSERT_LE(base.velocity().norm(), 2.0 + 1e-9);
    ASSERT_LE(std::abs(base.yawRate()), 1.0);
  }
}

TEST(SimulatedBase, LimitsYawAcceleration) {
  SimulatedBase base(realBase(), {});
  base.follow({{0.0, 0.0}, 1.0}, 0.25);  // 2 rad/s^2
  EXPECT_NEAR(base.yawRate(), 0.5, 1e-9);
  EXPECT_NEAR(base.pose().heading, 0.0625, 1e-9);
  base.follow({{0.0, 0.0}, 1.0}, 1.0);
  EXPECT_DOUBLE_EQ(base.yawRate(), 1.0);
}

TEST(SimulatedBase, NonFiniteCommandCountsAsZero) {
  SimulatedBase base(VehicleParams{}, {});
  base.follow({{1.0, 0.0}, 1.0}, 0.1);
  base.follow({{kNan, 1.0}, kNan}, 0.1);
  EXPECT_DOUBLE_EQ(base.velocity().norm(), 0.0);
  EXPECT_DOUBLE_EQ(base.yawRate(), 0.0);
  EXPECT_TRUE(base.pose().position.allFinite());
}

TEST(SimulatedBase, DoesNothingInNoTime) {
  SimulatedBase base(VehicleParams{}, {});
  for (double duration : {0.0, -1.0, kNan}) base.follow({{1.0, 0.0}, 1.0}, duration);
  EXPECT_DOUBLE_EQ(base.velocity().norm(), 0.0);
  EXPECT_DOUBLE_EQ(base.pose().position.norm(), 0.0);
}

TEST(SimulatedBase, PlacesAtRest) {
  SimulatedBase base = movingBase({1.0, 0.0});
  base.place({{3.0, 4.0}, 7.0});
  EXPECT_DOUBLE_EQ(base.velocity().norm(), 0.0);
  EXPECT_EQ(base.pose().position, Point(3.0, 4.0));
  EXPECT_NEAR(base.pose().heading, 7.0 - 8.0 * std::atan(1.0), 1e-12);
}

TEST(SimulatedBase, ValidatesItsParams) {
  VehicleParams params;
  params.max_speed = 0.0;
  EXPECT_THROW(SimulatedBase(params, {}), std::invalid_argument);
}

}  // namespace
}  // namespace pomdp_crowd_nav
