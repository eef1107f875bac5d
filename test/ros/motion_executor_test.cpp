// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/ros/motion_executor.h"

#include <gtest/gtest.h>

#include <cmath>

namespace pomdp_crowd_nav {
namespace {

constexpr double kPeriod = 0.05;  // [s]

VehicleParams slowBase() {
  VehicleParams vehicle;
  vehicle.max_speed = 1.0;
  vehicle.instant_velocity = false;
  return vehicle;
}

RobotReading readingAt(double time, const Point& position, const Point& velocity) {
  RobotReading reading;
  reading.measured_at = time;
  reading.pose.position = position;
  reading.velocity = velocity;
  return reading;
}

StepMotion speedUp() {  // from rest to 0.5 m/s along x in 0.5 s
  return stepMotion(slowBase(), VehicleState{Point(0.0, 0.0), 0.0, 0.0}, 0.0, 0.5, 0.5);
}

TEST(MotionExecutor, RestsWithoutAMotion) {
  MotionExecutor executor({}, slowBase(), kPeriod);
  EXPECT_TRUE(executor.isStopping(10.0));
  const BaseCommand command = executor.commandAt(10.0, RobotReading());
  EXPECT_EQ(command.velocity.norm(), 0.0);
  const VehicleState state = executor.predict(readingAt(10.0, Point(1.0, 2.0), {0.01, 0.0}), 11.0);
  EXPECT_EQ(state.position, Point(1.0, 2.0));
  EXPECT_EQ(state.speed, 0.0);
}

TEST(MotionExecutor, BeginsAMotionAtItsTimeAndNotBefore) {
  MotionExecutor executor({}, slowBase(), kPeriod);
  executor.follow(speedUp(), 10.0);
  EXPECT_EQ(executor.commandAt(9.90, RobotReading()).velocity.norm(), 0.0);
  double speed = 0.0;
  for (double now = 10.0; now < 10.5; now += kPeriod) {
    speed = executor.commandAt(now, RobotReading()).velocity.x();
  }
  EXPECT_NEAR(speed, 0.5, 1e-9);
}

TEST(MotionExecutor, PredictsFromTheReadingAlongWhatIsLeft) {
  MotionExecutor executor({}, slowBase(), kPeriod);
  executor.follow(speedUp(), 10.0);
  // Measured off the planned line: what is left of the motion is added to where the base is.
  const RobotReading reading = readingAt(10.25, Point(3.0, 1.0), Point(0.25, 0.0));
  const VehicleState state = executor.predict(reading, 10.5);
  EXPECT_NEAR(state.speed, 0.5, 1e-9);
  EXPECT_NEAR(state.position.x(), 3.0 + 0.125 - 0.03125, 1e-9);
  EXPECT_NEAR(state.position.y(), 1.0, 1e-9);
}

TEST(MotionExecutor, PredictsAcrossTheStartOfTheNextMotion) {
  MotionExecutor executor({}, slowBase(), kPeriod);
  StepMotion cruise = speedUp();
  cruise.start_velocity = cruise.end_velocity;
  executor.follow(cruise, 10.0);
  const RobotReading reading = readingAt(9.9, Point(0.0, 0.0), Point(0.5, 0.0));
  EXPECT_NEAR(executor.predict(reading, 10.5).position.x(), 0.3, 1e-9);
}

TEST(MotionExecutor, PredictsTheBrakeAfterAMotionThatNobodyFollowedUp) {
  CommandGenerator::Params params;
  params.hold_time = 0.1;
  MotionExecutor executor(params, slowBase(), kPeriod);
  executor.follow(speedUp(), 10.0);
  const RobotReading reading = readingAt(10.5, Point(0.0, 0.0), Point(0.5, 0.0));
  const VehicleState state = executor.predict(reading, 12.0);
  EXPECT_EQ(state.speed, 0.0);
  EXPECT_NEAR(state.position.x(), 0.05 + 0.125, 1e-9);
}

// Measured off its planned heading: it turns by what is left of the arc.
TEST(MotionExecutor, PredictsTheTurnOfACar) {
  VehicleParams car;
  car.kind = VehicleKind::kCar;
  MotionExecutor executor({}, car, kPeriod);
  executor.follow(stepMotion(car, {{0.0, 0.0}, 0.0, 2.0}, 0.6, 2.0, 1.0), 10.0);
  RobotReading reading = readingAt(10.5, Point(1.0, 0.2), 2.0 * unitVector(0.35));
  reading.pose.heading = 0.35;
  const VehicleState state = executor.predict(reading, 11.0);
  EXPECT_NEAR(state.heading, 0.35 + 0.3, 1e-9);
  EXPECT_NEAR(state.speed, 2.0, 1e-9);
  executor.stop();
  reading.velocity = {0.0, 0.0};
  EXPECT_NEAR(executor.predict(reading, 11.0).heading, 0.35, 1e-9) << "it faces where it drives";
}

TEST(MotionExecutor, StopDropsTheMotionAndPredictsTheBrake) {
  MotionExecutor executor({}, slowBase(), kPeriod);
  executor.follow(speedUp(), 10.0);
  executor.stop();
  EXPECT_EQ(executor.stopCount(), 1);
  EXPECT_TRUE(executor.isStopping(10.2));
  const VehicleState state =
      executor.predict(readingAt(10.2, Point(0.0, 0.0), Point(0.0, 0.5)), 10.45);
  EXPECT_NEAR(state.speed, 0.25, 1e-9);
  EXPECT_NEAR(state.heading, M_PI_2, 1e-9);
  EXPECT_NEAR(state.position.y(), 0.09375, 1e-9);
}

}  // namespace
}  // namespace pomdp_crowd_nav
