// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/world/vehicle.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace pomdp_crowd_nav {
namespace {

VehicleParams rampedBase() {
  VehicleParams params;
  params.instant_velocity = false;
  params.max_speed = 2.0;
  params.lateral_acceleration = 0.5;
  params.brake_deceleration = 1.5;
  return params;
}

void expectNear(const Point& found, double x, double y) {
  EXPECT_NEAR(found.x(), x, 1e-12);
  EXPECT_NEAR(found.y(), y, 1e-12);
}

TEST(VehicleTest, EachParameterMustBePositive) {
  EXPECT_NO_THROW(validate(VehicleParams()));
  using Field = double VehicleParams::*;
  for (Field field :
       {&VehicleParams::radius, &VehicleParams::max_speed, &VehicleParams::acceleration,
        &VehicleParams::lateral_acceleration, &VehicleParams::brake_deceleration,
        &VehicleParams::max_yaw_rate, &VehicleParams::yaw_acceleration}) {
    for (double bad : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
      VehicleParams params;
      params.*field = bad;
      EXPECT_THROW(validate(params), std::invalid_argument) << bad;
    }
  }
}

TEST(VehicleTest, RejectionNamesTheFieldAndItsValue) {
  VehicleParams params;
  params.brake_deceleration = -0.5;
  try {
    validate(params);
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_EQ(std::string(error.what()), "brake_deceleration must be positive, got -0.5");
  }
}

TEST(VehicleTest, SpeedStaysBetweenRestAndItsLimit) {
  const VehicleParams params = rampedBase();
  EXPECT_DOUBLE_EQ(speedAfter(params, 0.5, 1.0), 1.5);
  EXPECT_DOUBLE_EQ(speedAfter(params, 1.5, 1.0), 2.0);
  EXPECT_DOUBLE_EQ(speedAfter(params, 0.5, -1.0), 0.0);
}

TEST(VehicleTest, BrakeTakesSpeedOffUntilRest) {
  VehicleParams params = rampedBase();
  EXPECT_DOUBLE_EQ(speedAfterBrake(params, 2.0, 1.0), 0.5);
  EXPECT_DOUBLE_EQ(speedAfterBrake(params, 1.0, 1.0), 0.0);
  EXPECT_NEAR(stoppingDistance(params, 2.0), 4.0 / 3.0, 1e-12);
  params.instant_velocity = true;
  EXPECT_DOUBLE_EQ(speedAfterBrake(params, 2.0, 0.1), 0.0);
  EXPECT_DOUBLE_EQ(stoppingDistance(params, 2.0), 0.0);
}

// 0.5 m/s^2 across for 1 s changes the velocity by 0.5 m/s.
TEST(VehicleTest, LateralAccelerationBoundsTheTurn) {
  VehicleParams params = rampedBase();
  EXPECT_DOUBLE_EQ(maxTurnChord(params, 2.0, 1.0), 0.25);
  EXPECT_DOUBLE_EQ(maxTurnChord(params, 1.0, 2.0), 1.0);
  EXPECT_DOUBLE_EQ(maxTurnChord(params, 0.2, 1.0), 2.0);
  EXPECT_DOUBLE_EQ(maxTurnChord(params, 0.0, 1.0), 2.0);
  params.instant_velocity = true;
  EXPECT_DOUBLE_EQ(maxTurnChord(params, 2.0, 1.0), 2.0);
}

TEST(VehicleTest, TurnsTheShortWayAsFarAsTheChordAllows) {
  EXPECT_DOUBLE_EQ(turnToward(0.0, 2.5, 2.0), 2.5);
  EXPECT_NEAR(turnToward(0.0, 2.5, 1.0), M_PI / 3.0, 1e-12);  // a chord of 1 spans 60 degrees
  EXPECT_NEAR(turnToward(0.0, -2.5, 1.0), -M_PI / 3.0, 1e-12);
  EXPECT_NEAR(turnToward(0.5, 0.6, 1.0), 0.6, 1e-12);
  EXPECT_NEAR(turnToward(3.0, -3.0, 1.0), -3.0, 1e-12);  // across pi
  EXPECT_NEAR(turnToward(3.0, -2.0, 1.0), 3.0 + M_PI / 3.0 - 2.0 * M_PI, 1e-12);
  EXPECT_DOUBLE_EQ(turnToward(0.7, -1.0, 0.0), 0.7);
}

TEST(VehicleTest, InstantBaseDrivesAtTheNewVelocityFromTheStart) {
  const VehicleState from{{1.0, 2.0}, 0.0, 1.0};
  const StepMotion motion = stepMotion(VehicleParams(), from, M_PI / 2.0, 2.0, 1.0);
  expectNear(motion.velocityAt(0.0), 0.0, 2.0);
  expectNear(motion.positionAt(0.0), 1.0, 2.0);
  expectNear(motion.positionAt(0.5), 1.0, 3.0);
  const VehicleState end = motion.end();
  expectNear(end.position, 1.0, 4.0);
  EXPECT_DOUBLE_EQ(end.heading, M_PI / 2.0);
  EXPECT_DOUBLE_EQ(end.speed, 2.0);
}

TEST(VehicleTest, RampedBaseChangesItsVelocityLinearly) {
  const VehicleState from{{1.0, 2.0}, 0.0, 1.0};
  const StepMotion motion = stepMotion(rampedBase(), from, 0.0, 2.0, 2.0);
  expectNear(motion.velocityAt(0.0), 1.0, 0.0);
  expectNear(motion.velocityAt(1.0), 1.5, 0.0);
  expectNear(motion.positionAt(1.0), 1.0 + 1.0 + 0.25, 2.0);  // v t + a t^2 / 2, a = 0.5
  expectNear(motion.end().position, 1.0 + 3.0, 2.0);
  EXPECT_DOUBLE_EQ(motion.end().speed, 2.0);
  expectNear(motion.positionAt(3.0), 4.0 + 2.0, 2.0);  // goes on at the end velocity
}

// From 1 m/s along x to 1 m/s at 60 degrees: the chord of 1 is what 0.5 m/s^2 does in 2 s.
TEST(VehicleTest, RampedBaseTurnsNoFurtherThanItCan) {
  const VehicleState from{{0.0, 0.0}, 0.0, 1.0};
  const StepMotion motion = stepMotion(rampedBase(), from, M_PI / 2.0, 1.0, 2.0);
  EXPECT_NEAR(motion.end_heading, M_PI / 3.0, 1e-12);
  const double sine = std::sqrt(3.0) / 2.0;
  expectNear(motion.velocityAt(1.0), 0.75, 0.5 * sine);
  expectNear(motion.positionAt(1.0), 1.0 - 0.125, 0.25 * sine);
  expectNear(motion.end().position, 1.5, sine);
}

TEST(VehicleTest, HeadingIsKeptWhenTheBaseStops) {
  const VehicleState from{{0.0, 0.0}, 0.3, 1.0};
  const VehicleState end = stepMotion(rampedBase(), from, 0.3, 0.0, 1.0).end();
  EXPECT_DOUBLE_EQ(end.heading, 0.3);
  EXPECT_DOUBLE_EQ(end.speed, 0.0);
  expectNear(end.position, 0.5 * std::cos(0.3), 0.5 * std::sin(0.3));
}

VehicleParams paperCar() {
  VehicleParams params;
  params.kind = VehicleKind::kCar;
  params.max_speed = 4.0;
  params.max_yaw_rate = 3.2;
  return params;
}

TEST(VehicleTest, AnglesOfACarAreBounded) {
  for (const double bad : {0.0, -0.1, 1.6, std::nan("")}) {
    VehicleParams params = paperCar();
    params.max_turn_per_step = bad;
    EXPECT_THROW(validate(params), std::invalid_argument) << bad;
    params = paperCar();
    params.max_steering_angle = bad;
    EXPECT_THROW(validate(params), std::invalid_argument) << bad;
    params = paperCar();
    params.wheelbase = bad == 1.6 ? 0.0 : bad;
    EXPECT_THROW(validate(params), std::invalid_argument) << bad;
  }
}

// Bicycle of wheelbase 1 m, steering angle atan(turn / length): an arc of radius length / turn.
TEST(VehicleTest, ACarDrivesAnArc) {
  const double turn = M_PI / 6.0;
  const StepMotion motion = stepMotion(paperCar(), {{1.0, 2.0}, 0.0, 3.0}, turn, 4.0, 1.0);
  const double radius = 4.0 / turn;
  expectNear(motion.positionAt(1.0), 1.0 + radius * std::sin(turn),
             2.0 + radius * (1.0 - std::cos(turn)));
  expectNear(motion.positionAt(0.5), 1.0 + radius * std::sin(0.5 * turn),
             2.0 + radius * (1.0 - std::cos(0.5 * turn)));
  EXPECT_NEAR(motion.headingAt(0.5), 0.5 * turn, 1e-12);
  EXPECT_NEAR(motion.end().heading, turn, 1e-12);
  EXPECT_DOUBLE_EQ(motion.end().speed, 4.0);
}

TEST(VehicleTest, ACarTurnsNoFartherThanItCan) {
  VehicleParams params = paperCar();
  const auto turned = [&](double desired, double speed) {
    return stepMotion(params, {{0.0, 0.0}, 0.0, speed}, desired, speed, 1.0).end_heading;
  };
  EXPECT_NEAR(turned(2.0, 2.0), M_PI / 4.0, 1e-12);
  EXPECT_NEAR(turned(-2.0, 1.0), -M_PI / 4.0, 1e-12);
  EXPECT_NEAR(turned(2.0, 0.5), 0.5 * std::tan(0.67), 1e-12) << "the tightest curve";
  params.max_yaw_rate = 0.3;
  EXPECT_NEAR(turned(2.0, 2.0), 0.3, 1e-12);
}

TEST(VehicleTest, ACarAtRestKeepsItsHeading) {
  const VehicleState end = stepMotion(paperCar(), {{1.0, 1.0}, 0.4, 2.0}, 1.0, 0.0, 1.0).end();
  expectNear(end.position, 1.0, 1.0);
  EXPECT_DOUBLE_EQ(end.heading, 0.4);
  EXPECT_EQ(end.speed, 0.0);
}

TEST(VehicleTest, ARampedCarSpeedsUpOnItsArc) {
  VehicleParams params = paperCar();
  params.instant_velocity = false;
  params.lateral_acceleration = 0.5;
  const StepMotion motion = stepMotion(params, {{0.0, 0.0}, 0.0, 1.0}, 1.0, 2.0, 1.0);
  // 1.5 m at a curvature of 0.5 / 2^2 per metre.
  EXPECT_NEAR(motion.end_heading, 1.5 * 0.125, 1e-12);
  EXPECT_NEAR(motion.headingAt(0.5), 0.625 * 0.125, 1e-12);
  expectNear(motion.end().position, 8.0 * std::sin(0.1875), 8.0 * (1.0 - std::cos(0.1875)));
}

TEST(VehicleTest, TheArcToAPlaceEndsThere) {
  const VehicleState from{{1.0, 2.0}, 0.5, 2.0};
  for (const double angle : {-1.2, -0.3, 0.0, 0.7}) {
    const Point place = from.position + 3.0 * unitVector(from.heading + angle);
    const auto arc = arcTo(from, place);
    ASSERT_TRUE(arc);
    EXPECT_NEAR(arc->turn, 2.0 * angle, 1e-12);
    EXPECT_NEAR((from.position + arc->displacement(arc->length) - place).norm(), 0.0, 1e-12);
  }
  EXPECT_FALSE(arcTo(from, from.position - unitVector(0.5))) << "behind";
}

TEST(VehicleTest, ACarStopsAtAPlaceOnItsWay) {
  const VehicleState from{{0.0, 0.0}, 0.0, 4.0};
  const StepMotion motion = stepMotion(paperCar(), from, 0.2, 4.0, 1.0);
  const Point place = 2.5 * unitVector(0.2);
  const auto stopped = stopAt(paperCar(), place, from, motion);
  ASSERT_TRUE(stopped);
  expectNear(stopped->end().position, place.x(), place.y());
  EXPECT_NEAR(stopped->end().speed, stopped->legs.front().length, 1e-12);
  EXPECT_FALSE(stopAt(paperCar(), {4.5, 0.0}, from, motion)) << "farther than it gets";
  EXPECT_FALSE(stopAt(paperCar(), {2.0, 1.5}, from, motion)) << "too sharp";
}

TEST(VehicleTest, ARampedCarStopsOnlyWhereItCanSlowDownSoMuch) {
  VehicleParams params = paperCar();
  params.instant_velocity = false;
  params.acceleration = 2.0;
  const VehicleState from{{0.0, 0.0}, 0.0, 3.0};
  const StepMotion motion = stepMotion(params, from, 0.0, 4.0, 0.5);
  ASSERT_NEAR(motion.legs.front().length, 1.75, 1e-12);
  // From 3 m/s to 2 m/s in 0.5 s takes 1.25 m, and no less.
  EXPECT_FALSE(stopAt(params, {0.5, 0.0}, from, motion));
  EXPECT_FALSE(stopAt(params, {1.24, 0.0}, from, motion));
  for (const double way : {1.26, 1.5, 1.74}) {
    const auto stopped = stopAt(params, {way, 0.0}, from, motion);
    ASSERT_TRUE(stopped) << way;
    expectNear(stopped->start_velocity, 3.0, 0.0);
    expectNear(stopped->end().position, way, 0.0);
    EXPECT_NEAR(stopped->end().speed, 4.0 * way - 3.0, 1e-12);
    for (double time = 0.0; time < 0.49; time += 0.01) {
      const double change =
          stopped->velocityAt(time + 0.01).norm() - stopped->velocityAt(time).norm();
      EXPECT_LE(std::abs(change), 2.0 * 0.01 + 1e-9) << way << " m, " << time << " s";
    }
  }
}

// A quarter of a circle of radius 2 m, then straight on for 3 m.
StepMotion roundTheCorner() {
  StepMotion motion;
  motion.start = {1.0, 1.0};
  motion.start_velocity = {2.0, 0.0};
  motion.end_velocity = {0.0, 2.0};
  motion.end_heading = M_PI / 2.0;
  motion.duration = 4.0;
  motion.legs = {{0.0, M_PI / 2.0, M_PI}, {M_PI / 2.0, 0.0, 3.0}};
  return motion;
}

TEST(VehicleTest, LegsAreDrivenOneAfterTheOther) {
  const StepMotion motion = roundTheCorner();
  expectNear(motion.positionAt(0.0), 1.0, 1.0);
  expectNear(motion.velocityAt(0.0), 2.0, 0.0);
  const double eighth = M_PI / 4.0;
  expectNear(motion.positionAt(eighth), 1.0 + 2.0 * std::sin(eighth), 3.0 - 2.0 * std::cos(eighth));
  EXPECT_NEAR(motion.headingAt(eighth), eighth, 1e-12);
  expectNear(motion.positionAt(M_PI / 2.0), 3.0, 3.0);
  expectNear(motion.positionAt(M_PI / 2.0 + 1.0), 3.0, 5.0);
  expectNear(motion.velocityAt(M_PI / 2.0 + 1.0), 0.0, 2.0);
}

TEST(VehicleTest, WhoHasDrivenAllLegsWaitsForTheEndOfTheStep) {
  const StepMotion motion = roundTheCorner();
  expectNear(motion.positionAt(3.9), 3.0, 6.0);
  expectNear(motion.velocityAt(3.9), 0.0, 0.0);
  expectNear(motion.end().position, 3.0, 6.0);
  EXPECT_DOUBLE_EQ(motion.end().speed, 2.0);
  expectNear(motion.positionAt(4.5), 3.0, 7.0);  // straight on after the step
}

TEST(VehicleTest, RampedBaseSpeedsUpAlongLegs) {
  StepMotion motion = roundTheCorner();
  motion.instant = false;
  motion.start_velocity = {0.0, 0.0};
  // 0.5 m/s^2: pi metres, the arc, after sqrt(4 pi) s.
  const double arc_time = std::sqrt(4.0 * M_PI);
  expectNear(motion.positionAt(arc_time), 3.0, 3.0);
  EXPECT_NEAR(motion.velocityAt(arc_time).norm(), 0.5 * arc_time, 1e-12);
  EXPECT_NEAR(motion.headingAt(0.5 * arc_time), M_PI / 8.0, 1e-12);  // a quarter of the way
}

}  // namespace
}  // namespace pomdp_crowd_nav
