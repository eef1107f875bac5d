// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/control/command_generator.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

#include "pomdp_crowd_nav/sim/base.h"

namespace pomdp_crowd_nav {
namespace {

constexpr double kPeriod = 0.05;  // [s]

VehicleParams rampedBase() {
  VehicleParams vehicle;
  vehicle.max_speed = 1.5;
  vehicle.acceleration = 1.0;
  vehicle.brake_deceleration = 2.0;
  vehicle.max_yaw_rate = 0.8;
  vehicle.yaw_acceleration = 1.6;
  vehicle.instant_velocity = false;
  return vehicle;
}

// In the planning frame.
Point turnedBack(const BaseCommand& command, double yaw) {
  return {std::cos(yaw) * command.velocity.x() - std::sin(yaw) * command.velocity.y(),
          std::sin(yaw) * command.velocity.x() + std::cos(yaw) * command.velocity.y()};
}

StepMotion motionOf(const VehicleParams& vehicle, const VehicleState& from, double heading,
                    double speed) {
  return stepMotion(vehicle, from, heading, speed, 0.5);
}

TEST(CommandGenerator, WithoutAMotionTheBaseRests) {
  CommandGenerator generator({}, VehicleParams());
  EXPECT_TRUE(generator.isStopping(0.0));
  const BaseCommand command = generator.commandAt(3.0, 0.7, {0.0, 0.0});
  EXPECT_EQ(command.velocity, Point(0.0, 0.0));
  EXPECT_EQ(command.yaw_rate, 0.0);
}

TEST(CommandGenerator, AnInstantMotionIsCommandedInTheBaseFrame) {
  const VehicleParams vehicle;
  CommandGenerator generator({}, vehicle);
  generator.follow(motionOf(vehicle, {{0.0, 0.0}, 0.0, 0.0}, M_PI / 2.0, 2.0), 10.0);
  const BaseCommand command = generator.commandAt(10.0, 0.0, {0.0, 0.0});
  EXPECT_NEAR(command.velocity.x(), 0.0, 1e-12);
  EXPECT_NEAR(command.velocity.y(), 2.0, 1e-12) << "north is left of a robot that looks east";
  EXPECT_NEAR(command.yaw_rate, vehicle.max_yaw_rate, 1e-12) << "the body follows, to the left";
  const BaseCommand turned = generator.commandAt(10.05, M_PI / 2.0, {0.0, 2.0});
  EXPECT_NEAR(turned.velocity.x(), 2.0, 1e-12);
  EXPECT_NEAR(turned.yaw_rate, 0.0, 1e-12);
}

TEST(CommandGenerator, YawFollowsTheShorterWay) {
  CommandGenerator::Params params;
  params.yaw_gain = 2.0;
  const VehicleParams vehicle;
  CommandGenerator generator(params, vehicle);
  generator.follow(motionOf(vehicle, {{0.0, 0.0}, 3.0, 1.0}, 3.0, 1.0), 10.0);
  EXPECT_NEAR(generator.commandAt(10.0, -3.0, {0.0, 0.0}).yaw_rate, 2.0 * (6.0 - 2.0 * M_PI), 1e-9);
}

// Each command is the velocity to have when the next one comes.
TEST(CommandGenerator, FollowsARampWithoutLag) {
  const VehicleParams vehicle = rampedBase();
  CommandGenerator generator({}, vehicle);
  generator.commandAt(10.0 - kPeriod, 0.0, {0.0, 0.0});
  generator.follow(motionOf(vehicle, {{0.0, 0.0}, 0.0, 0.4}, 0.0, 0.9), 10.0);
  for (int i = 0; i < 10; ++i) {
    const double now = 10.0 + i * kPeriod;
    const BaseCommand command = generator.commandAt(now, 0.0, {0.0, 0.0});
    EXPECT_NEAR(command.velocity.x(), 0.4 + 0.05 * (i + 1), 1e-9) << i;
  }
}

// A base that takes each command at once ends where the way ends, round corners and bends.
TEST(CommandGenerator, FollowsABentWayToItsEnd) {
  VehicleParams vehicle;
  vehicle.max_speed = 4.0;
  StepMotion motion;
  motion.start = {1.0, 2.0};
  motion.start_velocity = {2.0, 0.0};
  motion.end_velocity = 3.0 * unitVector(2.0);
  motion.end_heading = 2.0;
  motion.legs = {{0.0, 0.0, 0.77}, {0.8, 0.0, 1.0}, {1.2, 0.8, 1.23}};
  CommandGenerator generator({}, vehicle);
  generator.commandAt(10.0 - 0.1, 0.0, {0.0, 0.0});
  generator.follow(motion, 10.0);
  SimulatedBase base(vehicle, {motion.start, 0.0});
  for (int i = 0; i < 10; ++i) {
    const double now = 10.0 + 0.1 * i;
    base.follow(generator.commandAt(now, base.pose().heading, base.velocity()), 0.1);
    const Point expected = motion.positionAt(0.1 * (i + 1));
    EXPECT_NEAR((base.pose().position - expected).norm(), 0.0, 1e-9) << i;
  }
}

VehicleParams car() {
  VehicleParams vehicle;
  vehicle.kind = VehicleKind::kCar;
  vehicle.max_speed = 4.0;
  vehicle.max_yaw_rate = 3.2;
  return vehicle;
}

// Ten steps of a car, each of ten commands: it is where the motions lead, and never slips sideways.
void expectCarInLockstep(const VehicleParams& vehicle, double tolerance) {
  std::mt19937_64 random(4);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  CommandGenerator generator({}, vehicle);
  SimulatedBase base(vehicle, {{1.0, 2.0}, 0.4});
  VehicleState state{{1.0, 2.0}, 0.4, 0.0};
  generator.commandAt(-0.1, 0.4, {0.0, 0.0});
  for (int step = 0; step < 10; ++step) {
    const double speed = std::clamp(state.speed + std::round(2.0 * unit(random)) - 1.0, 0.0, 4.0);
    const StepMotion motion =
        stepMotion(vehicle, state, state.heading + 2.0 * unit(random) - 1.0, speed, 1.0);
    generator.follow(motion, step);
    for (int i = 0; i < 10; ++i) {
      const BaseCommand command =
          generator.commandAt(step + 0.1 * i, base.pose().heading, base.velocity());
      EXPECT_EQ(command.velocity.y(), 0.0);
      base.follow(command, 0.1);
      const Point expected = motion.positionAt(0.1 * (i + 1));
      ASSERT_NEAR((base.pose().position - expected).norm(), 0.0, tolerance) << step << ' ' << i;
    }
    state = motion.end();
    ASSERT_NEAR(wrapAngle(base.pose().heading - state.heading), 0.0, tolerance);
  }
  EXPECT_GT((base.pose().position - Point(1.0, 2.0)).norm(), 5.0);
}

TEST(CommandGenerator, ACarEndsWhereItsArcsEnd) { expectCarInLockstep(car(), 1e-9); }

TEST(CommandGenerator, ARampedCarEndsWhereItsArcsEnd) {
  VehicleParams vehicle = car();
  vehicle.instant_velocity = false;
  vehicle.acceleration = 1.0;
  vehicle.brake_deceleration = 1.0;
  vehicle.lateral_acceleration = 2.0;
  expectCarInLockstep(vehicle, 1e-6);
}

TEST(CommandGenerator, ACarSteersBackToItsHeading) {
  CommandGenerator generator({}, car());
  generator.follow(stepMotion(car(), {{0.0, 0.0}, 0.0, 2.0}, 0.0, 2.0, 1.0), 10.0);
  const BaseCommand command = generator.commandAt(10.0, 0.1, {2.0, 0.0});
  EXPECT_NEAR(command.yaw_rate, -0.2, 1e-9) << "the yaw gain is 2 per second";
  EXPECT_EQ(command.velocity, Point(2.0, 0.0));
}

TEST(CommandGenerator, ACarBrakesOnItsCurve) {
  VehicleParams vehicle = car();
  vehicle.instant_velocity = false;
  vehicle.lateral_acceleration = 2.0;
  vehicle.brake_deceleration = 2.0;
  CommandGenerator generator({}, vehicle);
  const StepMotion motion = stepMotion(vehicle, {{0.0, 0.0}, 0.0, 2.0}, 0.5, 2.0, 1.0);
  generator.follow(motion, 10.0);
  const BaseCommand driving = generator.commandAt(10.0, 0.0, {2.0, 0.0});
  EXPECT_NEAR(driving.yaw_rate, 0.5, 1e-9);
  generator.stop();
  const BaseCommand braking = generator.commandAt(10.1, 0.05, 2.0 * unitVector(0.05));
  EXPECT_NEAR(braking.velocity.x(), 1.8, 1e-9);
  EXPECT_NEAR(braking.yaw_rate, 0.45, 1e-9) << "the same curvature";
  EXPECT_EQ(generator.commandAt(12.0, 0.05, {0.0, 0.0}).velocity.norm(), 0.0);
  EXPECT_EQ(generator.commandAt(12.1, std::nan(""), {std::nan(""), 0.0}).yaw_rate, 0.0);
}

TEST(CommandGenerator, HoldsPastTheEndAndThenBrakes) {
  CommandGenerator::Params params;
  params.hold_time = 0.2;
  const VehicleParams vehicle = rampedBase();
  CommandGenerator generator(params, vehicle);
  generator.follow(motionOf(vehicle, {{0.0, 0.0}, 0.0, 1.0}, 0.0, 1.0), 10.0);
  for (int i = 0; i <= 14; ++i) {
    const double now = 10.0 + i * kPeriod - 1e-9;
    EXPECT_FALSE(generator.isStopping(now));
    EXPECT_NEAR(generator.commandAt(now, 0.0, {1.0, 0.0}).velocity.x(), 1.0, 1e-9) << now;
  }
  double speed = 1.0;
  for (int i = 15; i < 30; ++i) {
    const double now = 10.0 + i * kPeriod;
    EXPECT_TRUE(generator.isStopping(now));
    const double slower = generator.commandAt(now, 0.0, {speed, 0.0}).velocity.x();
    EXPECT_NEAR(slower, std::max(0.0, speed - 2.0 * kPeriod), 1e-6) << "the brake's deceleration";
    speed = slower;
  }
  EXPECT_EQ(speed, 0.0);
}

TEST(CommandGenerator, AnInstantBaseStopsAtOnce) {
  const VehicleParams vehicle;
  CommandGenerator generator({}, vehicle);
  generator.follow(motionOf(vehicle, {{0.0, 0.0}, 0.0, 2.0}, 0.0, 2.0), 10.0);
  EXPECT_EQ(generator.commandAt(10.0, 0.0, {2.0, 0.0}).velocity.x(), 2.0);
  generator.stop();
  EXPECT_TRUE(generator.isStopping(10.05));
  EXPECT_EQ(generator.commandAt(10.05, 0.0, {2.0, 0.0}).velocity, Point(0.0, 0.0));
}

TEST(CommandGenerator, BrakesFromTheMeasuredSpeedWhenThatIsLower) {
  const VehicleParams vehicle = rampedBase();
  CommandGenerator generator({}, vehicle);
  generator.follow(motionOf(vehicle, {{0.0, 0.0}, 0.0, 1.2}, 0.0, 1.2), 10.0);
  generator.commandAt(10.0, 0.0, {0.3, 0.0});
  generator.stop();
  EXPECT_NEAR(generator.commandAt(10.05, 0.0, {0.3, 0.0}).velocity.x(), 0.2, 1e-9);
}

TEST(CommandGenerator, ANewMotionEndsTheBrake) {
  const VehicleParams vehicle;
  CommandGenerator generator({}, vehicle);
  generator.stop();
  generator.follow(motionOf(vehicle, {{0.0, 0.0}, 0.0, 0.0}, 0.0, 1.0), 5.0);
  EXPECT_FALSE(generator.isStopping(5.0));
  EXPECT_NEAR(generator.commandAt(5.0, 0.0, {0.0, 0.0}).velocity.x(), 1.0, 1e-12);
}

TEST(CommandGenerator, AClockThatJumpsBackStopsTheBase) {
  const VehicleParams vehicle = rampedBase();
  CommandGenerator generator({}, vehicle);
  generator.follow(motionOf(vehicle, {{0.0, 0.0}, 0.0, 1.0}, 0.0, 1.0), 1000.0);
  EXPECT_NEAR(generator.commandAt(1000.1, 0.0, {1.0, 0.0}).velocity.x(), 1.0, 1e-9);
  double speed = 1.0;
  for (int i = 0; i < 40; ++i) {
    speed = generator.commandAt(1.0 + i * kPeriod, 0.0, {speed, 0.0}).velocity.x();
  }
  EXPECT_TRUE(generator.isStopping(3.0));
  EXPECT_EQ(speed, 0.0);
}

TEST(CommandGenerator, AMotionMayStartALittleLater) {
  const VehicleParams vehicle;
  CommandGenerator generator({}, vehicle);
  generator.follow(motionOf(vehicle, {{0.0, 0.0}, 0.0, 1.0}, 0.0, 1.0), 10.0);
  EXPECT_FALSE(generator.isStopping(9.975));
}

TEST(CommandGenerator, WithoutAHeadingNothingIsCommanded) {
  const VehicleParams vehicle;
  CommandGenerator generator({}, vehicle);
  generator.follow(motionOf(vehicle, {{0.0, 0.0}, 0.0, 1.0}, 0.0, 1.0), 10.0);
  const BaseCommand command = generator.commandAt(10.0, std::nan(""), {0.0, 0.0});
  EXPECT_EQ(command.velocity, Point(0.0, 0.0));
  EXPECT_EQ(command.yaw_rate, 0.0);
}

TEST(CommandGenerator, RecoversFromATimeThatIsNoNumber) {
  const VehicleParams vehicle = rampedBase();
  CommandGenerator generator({}, vehicle);
  generator.follow(motionOf(vehicle, {{0.0, 0.0}, 0.0, 1.0}, 0.0, 1.0), 10.0);
  generator.commandAt(10.0, 0.5, {1.0, 0.0});
  const BaseCommand lost = generator.commandAt(std::nan(""), 0.5, {1.0, 0.0});
  EXPECT_TRUE(lost.velocity.allFinite());
  EXPECT_TRUE(std::isfinite(lost.yaw_rate));
  const BaseCommand next = generator.commandAt(10.05, 0.5, {1.0, 0.0});
  EXPECT_NEAR(next.velocity.norm(), 1.0, 1e-9);
  EXPECT_TRUE(std::isfinite(next.yaw_rate));
}

// Whatever comes in: nonsense motions, readings and clocks.
TEST(CommandGenerator, CommandsAreFiniteAndWithinTheLimits) {
  const double strange[] = {std::nan(""), std::numeric_limits<double>::infinity(), -1e300, 1e300,
                            0.0};
  for (const bool instant : {false, true}) {
    VehicleParams vehicle = rampedBase();
    vehicle.instant_velocity = instant;
    CommandGenerator generator({}, vehicle);
    std::mt19937_64 random(1);
    std::normal_distribution<double> normal(0.0, 2.0);
    const auto any = [&] { return random() % 8 == 0 ? strange[random() % 5] : normal(random); };
    double now = 0.0;
    double last_yaw_rate = 0.0;
    for (int i = 0; i < 20000; ++i) {
      if (random() % 5 == 0) {
        StepMotion motion;
        motion.start_velocity = {any(), any()};
        motion.end_velocity = {any(), any()};
        motion.duration = random() % 4 == 0 ? any() : 0.5;
        motion.instant = instant;
        generator.follow(motion, random() % 4 == 0 ? any() : now);
      }
      if (random() % 40 == 0) generator.stop();
      const double before = now;
      now += random() % 50 == 0 ? normal(random) : kPeriod;
      const double time = random() % 50 == 0 ? any() : now;
      const double yaw = any();
      const BaseCommand command = generator.commandAt(time, yaw, {any(), any()});
      ASSERT_TRUE(command.velocity.allFinite());
      ASSERT_LE(command.velocity.norm(), vehicle.max_speed + 1e-9);
      ASSERT_LE(std::abs(command.yaw_rate), vehicle.max_yaw_rate + 1e-12);
      ASSERT_TRUE(std::isfinite(command.yaw_rate));
      if (!instant && std::isfinite(yaw) && time == now && now > before) {
        ASSERT_LE(std::abs(command.yaw_rate - last_yaw_rate), 1.6 * 0.2 + 1e-9);
      }
      last_yaw_rate = command.yaw_rate;
    }
  }
}

TEST(CommandGenerator, TheResultantIsLimitedNotEachAxis) {
  const VehicleParams vehicle = rampedBase();
  CommandGenerator generator({}, vehicle);
  StepMotion motion;
  motion.start_velocity = motion.end_velocity = Point(1.4, 1.4);
  motion.instant = false;
  generator.follow(motion, 1.0);
  const BaseCommand command = generator.commandAt(1.0, 0.3, {0.0, 0.0});
  EXPECT_NEAR(command.velocity.norm(), 1.5, 1e-9);
  const Point velocity = turnedBack(command, 0.3);
  EXPECT_NEAR(velocity.x(), velocity.y(), 1e-9) << "the direction is kept";
}

TEST(CommandGenerator, RejectsParametersOutOfRange) {
  CommandGenerator::Params params;
  params.hold_time = -0.1;
  EXPECT_THROW(CommandGenerator(params, VehicleParams()), std::invalid_argument);
  params = {};
  params.yaw_gain = std::nan("");
  EXPECT_THROW(CommandGenerator(params, VehicleParams()), std::invalid_argument);
  VehicleParams vehicle;
  vehicle.max_speed = 0.0;
  EXPECT_THROW(CommandGenerator({}, vehicle), std::invalid_argument);
}

// At 10 Hz, with corners between two commands and on them.
TEST(CommandGenerator, DrivesLegsExactly) {
  VehicleParams vehicle;
  for (const double speed : {1.0, 1.5, 2.0}) {
    StepMotion motion = stepMotion(vehicle, {{3.0, 4.0}, 0.3, 1.0}, 0.3, speed, 1.0);
    motion.legs = {{0.3, 0.0, 0.5 * speed}, {2.0, 0.0, 0.5 * speed}};
    CommandGenerator commands({}, vehicle);
    commands.commandAt(4.9, 0.0, {0.0, 0.0});
    commands.follow(motion, 5.0);
    Point position = motion.start;
    for (int tick = 0; tick < 10; ++tick) {
      position += 0.1 * commands.commandAt(5.0 + 0.1 * tick, 0.0, {0.0, 0.0}).velocity;
      EXPECT_LT((position - motion.positionAt(0.1 * (tick + 1))).norm(), 1e-9) << speed;
    }
  }
}

}  // namespace
}  // namespace pomdp_crowd_nav
