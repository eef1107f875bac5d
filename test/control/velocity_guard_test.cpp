// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/control/velocity_guard.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

#include "guarded_drive.h"

namespace pomdp_crowd_nav {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

TEST_F(GuardedDrive, SaysNothingWithoutAPlanner) {
  run(1.0);
  EXPECT_FALSE(output_.command);
  EXPECT_EQ(output_.cause, GuardCause::kNone);
}

TEST_F(GuardedDrive, ForwardsWhatIsWithinTheLimits) {
  driveAtFullSpeed();
  EXPECT_EQ(output_.command->velocity, command_.velocity);
  EXPECT_FALSE(output_.is_limited);
}

TEST_F(GuardedDrive, CutsWhatIsNot) {
  command_ = {{5.0, -5.0}, 0.0};
  has_command_ = true;
  run(3.0);
  EXPECT_NEAR(base_.velocity().norm(), 1.0, 1e-6);
  EXPECT_TRUE(output_.is_limited);
}

TEST_F(GuardedDrive, SilentPlannerBrakesTheBaseAndThenThereIsSilence) {
  driveAtFullSpeed();
  has_command_ = false;
  expectRest(0.25 + 1.0 + 0.1, GuardCause::kNoCommand);
  run(0.3);
  EXPECT_FALSE(output_.command) << "the base is at rest";
  EXPECT_EQ(output_.cause, GuardCause::kNoCommand);
  EXPECT_EQ(sent_.velocity, Point(0.0, 0.0)) << "the last that was sent";
}

TEST_F(GuardedDrive, PlannerThatEndsWithZeroIsNoFault) {
  driveAtFullSpeed();
  command_ = {};
  run(2.0);
  EXPECT_TRUE(output_.command) << "a fresh command is forwarded, zero or not";
  has_command_ = false;
  run(0.5);
  EXPECT_FALSE(output_.command);
  EXPECT_EQ(output_.cause, GuardCause::kNone);
}

TEST_F(GuardedDrive, SendsZerosForSomeTimeToABaseThatIsNotSeenToRest) {
  driveAtFullSpeed();
  has_command_ = has_odometry_ = false;
  run(3.0);
  EXPECT_TRUE(output_.command);
  EXPECT_EQ(sent_.velocity, Point(0.0, 0.0));
  run(5.0);
  EXPECT_FALSE(output_.command);
}

TEST_F(GuardedDrive, CommandThatIsNotFiniteBrakesAtOnce) {
  for (const BaseCommand& bad :
       {BaseCommand{{kNan, 0.0}, 0.0}, BaseCommand{{1.0, 0.0}, INFINITY}}) {
    driveAtFullSpeed();
    command_ = bad;
    expectRest(1.0 + 0.1, GuardCause::kCommandNotFinite);
  }
}

TEST_F(GuardedDrive, SilentOdometryBrakes) {
  driveAtFullSpeed();
  has_odometry_ = false;
  expectRest(0.5 + 1.0 + 0.1, GuardCause::kNoOdometry);
  has_odometry_ = true;
  driveAtFullSpeed();
}

TEST_F(GuardedDrive, OdometryThatCannotBeIsPassedOver) {
  driveAtFullSpeed();
  has_odometry_ = false;
  const double begin = now_;
  while (base_.velocity().norm() > 0.0 && now_ - begin < 3.0) {
    guard_.takeMotion({{1e300, 0.0}, 0.0}, {{1.0, 0.0}, 0.0}, now_);
    guard_.takeMotion({{3.0, 0.0}, 0.0}, {{1e9, 0.0}, 0.0}, now_);
    guard_.takeMotion({{kNan, 0.0}, 0.0}, {{1.0, 0.0}, 0.0}, now_);
    run(kPeriod);
  }
  EXPECT_LE(now_ - begin, 1.6);
  EXPECT_EQ(output_.cause, GuardCause::kOdometryNotFinite);
}

TEST_F(GuardedDrive, ShutDownBrakes) {
  driveAtFullSpeed();
  guard_.shutDown();
  expectRest(1.0 + 0.1, GuardCause::kShutDown);
  run(0.3);
  EXPECT_FALSE(output_.command);
}

// Whatever comes in: finite, within the limits, never faster than the last command, zero within the
// braking time of a planner's silence.
TEST(VelocityGuard, PropertiesHoldForRandomInputs) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  const double bad[] = {kNan, INFINITY, -INFINITY, 1e308, -1e-310};
  const auto number = [&] {
    return random() % 100 == 0 ? bad[random() % 5] : 2.0 * uniform(random);
  };
  VelocityGuard guard(params(), movo());
  BaseCommand command;
  double now = 10.0, command_at = -1.0, last_speed = 0.0;
  for (int i = 0; i < 50000; ++i) {
    now += 0.04 * std::abs(uniform(random));
    const bool is_silent = (i / 500) % 4 == 3;
    if (!is_silent && random() % 2 == 0) {
      command = {{number(), number()}, number()};
      guard.takeCommand(command, now);
      command_at = now;
    }
    if (random() % 3 == 0)
      guard.takeMotion({{number(), number()}, number()}, {{number(), number()}, number()},
                       now - 0.1 * std::abs(uniform(random)));
    if (random() % 4 == 0) {
      TrackList people;
      for (unsigned n = random() % 4; n > 0; --n) {
        people.tracks.push_back({n, {5.0 * number(), 5.0 * number()}, {number(), number()}});
      }
      guard.takePeople(people, now);
    }
    if (random() % 500 == 0) guard.noteClockJump(now);
    const VelocityGuard::Output output = guard.tick(now);
    const BaseCommand out = output.command.value_or(BaseCommand());
    ASSERT_TRUE(out.velocity.allFinite() && std::isfinite(out.yaw_rate));
    const double speed = out.velocity.norm();
    ASSERT_LE(speed, 1.0 + 1e-9);
    ASSERT_LE(std::abs(out.yaw_rate), 1.0 + 1e-9);
    const bool is_usable =
        command.velocity.allFinite() && std::isfinite(command.yaw_rate) && now - command_at <= 0.25;
    if (is_usable) {
      ASSERT_LE(std::abs(out.velocity.x()), std::abs(command.velocity.x()));
      ASSERT_LE(std::abs(out.velocity.y()), std::abs(command.velocity.y()));
      ASSERT_GE(out.velocity.x() * command.velocity.x(), 0.0);
      ASSERT_GE(out.velocity.y() * command.velocity.y(), 0.0);
      ASSERT_LE(std::abs(out.yaw_rate), std::abs(command.yaw_rate));
    } else {
      ASSERT_LE(speed, last_speed + 1e-12) << "it brakes";
      ASSERT_NE(output.cause, GuardCause::kPerson);
    }
    if (now - command_at > 0.25 + 1.0 + 0.2) {
      ASSERT_EQ(speed, 0.0);
    }
    last_speed = speed;
  }
}

TEST(VelocityGuard, RefusesParametersOutOfRange) {
  VelocityGuard::Params slow = params();
  slow.frequency = 10.0;
  EXPECT_THROW(VelocityGuard(slow, movo()), std::invalid_argument);
  VelocityGuard::Params hasty = params();
  hasty.command_timeout = 0.01;
  EXPECT_THROW(VelocityGuard(hasty, movo()), std::invalid_argument);
  VelocityGuard::Params touching = params();
  touching.margin = -0.1;
  try {
    validate(touching);
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "guard/margin must be at least 0, got -0.1");
  }
}

}  // namespace
}  // namespace pomdp_crowd_nav
