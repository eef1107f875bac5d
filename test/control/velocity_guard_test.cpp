// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/control/velocity_guard.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

#include "pomdp_crowd_nav/sim/base.h"

namespace pomdp_crowd_nav {
namespace {

constexpr double kPeriod = 0.02;  // [s]
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

VehicleParams movo() {
  VehicleParams vehicle;
  vehicle.radius = 0.5;
  vehicle.max_speed = 1.0;
  vehicle.acceleration = 1.0;
  vehicle.lateral_acceleration = 1.0;
  vehicle.brake_deceleration = 1.0;
  vehicle.instant_velocity = false;
  return vehicle;
}

VelocityGuard::Params params() {
  VelocityGuard::Params guard;
  guard.margin = 0.3;
  return guard;
}

// A base behind a guard, a planner in front of it, and people; any of them may fall silent.
class GuardedDrive : public testing::Test {
 protected:
  void run(double duration) {
    const double end = now_ + duration;
    for (; now_ < end; now_ += kPeriod, ++ticks_) {
      if (has_command_ && ticks_ % 2 == 0) guard_.takeCommand(command_, now_);
      if (has_odometry_) {
        const Point velocity = Eigen::Rotation2Dd(-base_.pose().heading) * base_.velocity();
        guard_.takeMotion(base_.pose(), {velocity, base_.yawRate()}, now_);
      }
      if (has_people_ && ticks_ % 5 == 0) guard_.takePeople(people_, now_);
      output_ = guard_.tick(now_);
      if (output_.command) sent_ = *output_.command;
      base_.follow(sent_, kPeriod);
      for (Track& person : people_.tracks) person.position += kPeriod * person.velocity;
      nearest_ = std::min(nearest_, distanceToPeople());
    }
  }

  void driveAtFullSpeed() {
    command_ = {{1.0, 0.0}, 0.0};
    has_command_ = true;
    run(2.0);
    ASSERT_NEAR(base_.velocity().x(), 1.0, 1e-3);
    ASSERT_EQ(output_.cause, GuardCause::kNone);
  }

  // From now on; fails if it takes longer than the bound.
  void expectRest(double bound, GuardCause cause) {
    bool named = false;
    const double begin = now_;
    while (base_.velocity().norm() > 0.0 && now_ - begin < bound + 1.0) {
      run(kPeriod);
      named = named || output_.cause == cause;
    }
    EXPECT_LE(now_ - begin, bound);
    EXPECT_TRUE(named) << "expected: " << describe(cause) << ", got: " << describe(output_.cause);
  }

  double distanceToPeople() const {
    double distance = std::numeric_limits<double>::infinity();
    for (const Track& person : people_.tracks) {
      distance = std::min(distance, (person.position - base_.pose().position).norm());
    }
    return distance;
  }

  VelocityGuard guard_{params(), movo()};
  SimulatedBase base_{movo(), Pose{{3.0, 2.0}, 0.0}};
  BaseCommand command_;
  BaseCommand sent_;
  VelocityGuard::Output output_;
  TrackList people_;
  bool has_command_ = false;
  bool has_odometry_ = true;
  bool has_people_ = true;
  double now_ = 100.0;  // [s]
  int ticks_ = 0;
  double nearest_ = std::numeric_limits<double>::infinity();
};

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

TEST_F(GuardedDrive, SilentPeopleBrakeButNobodyAboutDoesNot) {
  driveAtFullSpeed();
  run(5.0);
  EXPECT_EQ(output_.cause, GuardCause::kNone);
  has_people_ = false;
  expectRest(1.0 + 1.0 + 0.2, GuardCause::kNoPeople);
}

TEST_F(GuardedDrive, MissingTransformIsNamed) {
  driveAtFullSpeed();
  has_people_ = false;
  for (int i = 0; i < 60; ++i) {
    guard_.noteBadPeople(now_, GuardCause::kNoTransform);
    run(kPeriod);
  }
  EXPECT_EQ(output_.cause, GuardCause::kNoTransform);
}

TEST_F(GuardedDrive, RefusedPeopleAreNamed) {
  driveAtFullSpeed();
  has_people_ = false;
  run(0.5);
  guard_.noteBadPeople(now_, GuardCause::kPeopleRefused);
  expectRest(0.5 + 1.0 + 0.2, GuardCause::kPeopleRefused);
}

TEST_F(GuardedDrive, OneOfTwoSourcesOfPeopleIsEnough) {
  driveAtFullSpeed();
  has_people_ = false;
  for (int i = 0; i < 20; ++i) {
    guard_.takePeople(TrackList(), now_, 1);
    run(0.1);
  }
  EXPECT_NEAR(base_.velocity().x(), 1.0, 1e-3);
  expectRest(1.0 + 1.0 + 0.2, GuardCause::kNoPeople);
}

// The other source goes on to see nobody.
TEST_F(GuardedDrive, WhoeverOneOfTwoSourcesReportsCounts) {
  driveAtFullSpeed();
  TrackList somebody;
  somebody.tracks = {{7, base_.pose().position + Point(3.0, 0.0), {0.0, 0.0}}};
  for (int i = 0; i < 40; ++i) {
    guard_.takePeople(somebody, now_, 1);
    run(0.1);
  }
  EXPECT_EQ(base_.velocity().norm(), 0.0);
  EXPECT_EQ(output_.cause, GuardCause::kPerson);
  EXPECT_EQ(output_.person, 7);
}

// Nobody knows where that person is now.
TEST_F(GuardedDrive, ASourceThatGoesSilentWithSomebodyInViewIsMissedForAWhile) {
  TrackList somebody;
  somebody.tracks = {{7, {-50.0, 0.0}, {0.0, 0.0}}};  // far off
  driveAtFullSpeed();
  guard_.takePeople(somebody, now_, 1);
  expectRest(1.0 + 1.0 + 0.2, GuardCause::kNoPeople);
  run(11.0);
  EXPECT_GT(base_.velocity().norm(), 0.9);
}

TEST_F(GuardedDrive, PeopleOfLongAgoDoNotReplaceNewerOnes) {
  people_.tracks = {{7, {9.0, 2.2}, {0.0, 0.0}}};
  driveAtFullSpeed();
  for (int i = 0; i < 60; ++i) {
    guard_.takePeople(TrackList(), now_ - 2.0);
    run(0.1);
  }
  EXPECT_EQ(output_.cause, GuardCause::kPerson);
  EXPECT_EQ(base_.velocity().norm(), 0.0);
}

TEST_F(GuardedDrive, SomebodyTooFastToBeTrueStandsInTheWay) {
  driveAtFullSpeed();
  people_.tracks = {{7, base_.pose().position + Point(3.0, 0.0), {0.0, 1e6}}};
  TrackList standing = people_;
  has_people_ = false;
  for (int i = 0; i < 30; ++i) {
    guard_.takePeople(standing, now_);
    run(0.1);
  }
  EXPECT_EQ(output_.cause, GuardCause::kPerson);
}

TEST_F(GuardedDrive, ClockThatJumpsBrakesUntilInputsAreFresh) {
  driveAtFullSpeed();
  has_people_ = false;
  guard_.noteClockJump(now_);
  expectRest(1.0 + 0.1, GuardCause::kClockJumped);
  has_people_ = true;
  driveAtFullSpeed();
}

TEST_F(GuardedDrive, StopsShortOfAPersonInTheWay) {
  people_.tracks = {{7, {9.0, 2.2}, {0.0, 0.0}}};
  driveAtFullSpeed();
  expectRest(6.0, GuardCause::kPerson);
  EXPECT_EQ(output_.person, 7);
  EXPECT_GT(nearest_, 0.8);
  EXPECT_LT(nearest_, 1.3) << "no sooner than needed";
  run(3.0);
  EXPECT_EQ(output_.cause, GuardCause::kPerson) << "it stays there";
  EXPECT_EQ(base_.velocity().norm(), 0.0);
  people_.tracks.clear();
  run(0.1 + 0.5 + 2.0);
  EXPECT_GT(base_.velocity().norm(), 0.9) << "the way is free";
}

TEST_F(GuardedDrive, StopsForSomebodyWhoStepsIntoTheWay) {
  driveAtFullSpeed();
  people_.tracks = {{7, base_.pose().position + Point(1.6, 1.6), {0.0, -1.0}}};
  run(1.5);
  EXPECT_EQ(base_.velocity().norm(), 0.0);
  EXPECT_GT(nearest_, 0.5);
}

TEST_F(GuardedDrive, DrivesPastSomebodyBesideTheWay) {
  people_.tracks = {{7, {8.0, 2.85}, {0.0, 0.0}}};
  command_ = {{1.0, 0.0}, 0.0};
  has_command_ = true;
  run(12.0);
  EXPECT_GT(base_.pose().position.x(), 13.0);
}

TEST_F(GuardedDrive, MayTurnOnTheSpotAndDriveAwayFromSomebodyClose) {
  people_.tracks = {{7, {3.7, 2.0}, {0.0, 0.0}}};
  command_ = {{0.0, 0.0}, 0.5};
  has_command_ = true;
  run(0.5);
  EXPECT_GT(std::abs(sent_.yaw_rate), 0.4);
  command_ = {{-0.5, 0.0}, 0.0};
  run(1.0);
  EXPECT_GT(base_.velocity().norm(), 0.4);
}

TEST_F(GuardedDrive, ShutDownBrakes) {
  driveAtFullSpeed();
  guard_.shutDown();
  expectRest(1.0 + 0.1, GuardCause::kShutDown);
  run(0.3);
  EXPECT_FALSE(output_.command);
}

TEST_F(GuardedDrive, AGuardThatStartsWhileTheBaseDrivesTakesItOver) {
  driveAtFullSpeed();
  guard_ = VelocityGuard(params(), movo());
  run(0.3);
  EXPECT_GT(base_.velocity().norm(), 0.85) << "it goes on from the measured speed";
}

TEST_F(GuardedDrive, ANewGuardBesideADeadPlannerBrakesTheBase) {
  driveAtFullSpeed();
  guard_ = VelocityGuard(params(), movo());
  has_command_ = false;
  expectRest(0.25 + 1.0 + 0.1, GuardCause::kNoCommand);
  run(0.5);
  EXPECT_FALSE(output_.command) << "then it is silent";
}

// Such a base does not obey, so somebody else drives it.
TEST_F(GuardedDrive, ANewGuardGivesABaseUpThatGoesOnAgainstItsZeros) {
  guard_ = VelocityGuard(params(), movo());
  int last_command = 0;
  for (int i = 0; i < 300; ++i, now_ += 0.02) {
    guard_.takeMotion({{0.01 * i, 0.0}, 0.0}, {{0.5, 0.0}, 0.0}, now_);
    if (guard_.tick(now_).command) last_command = i;
  }
  EXPECT_GT(last_command * 0.02, 0.25 + 0.5);
  EXPECT_LT(last_command * 0.02, 0.25 + 0.5 + 1.0 + 0.2);
}

TEST_F(GuardedDrive, OdometryThatBeginsLongAfterTheGuardShowsABaseOfSomebodyElse) {
  guard_ = VelocityGuard(params(), movo());
  for (int i = 0; i < 300; ++i, now_ += 0.02) guard_.tick(now_);
  for (int i = 0; i < 100; ++i, now_ += 0.02) {
    guard_.takeMotion({{0.01 * i, 0.0}, 0.0}, {{0.5, 0.0}, 0.0}, now_);
    ASSERT_FALSE(guard_.tick(now_).command);
  }
}

// Somebody else drives it, by hand.
TEST_F(GuardedDrive, ABaseThatBeginsToMoveBesideANewGuardIsNotItsBusiness) {
  run(0.5);
  sent_ = {{0.5, 0.0}, 0.0};
  run(2.0);
  EXPECT_FALSE(output_.command);
  EXPECT_NEAR(base_.velocity().x(), 0.5, 1e-3);
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
