// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/ros/inputs.h"

#include <gtest/gtest.h>

#include "pomdp_crowd_nav/ros/input_health.h"

namespace pomdp_crowd_nav {
namespace {

using Level = InputHealth::Level;

// Everything fresh at `now_`; each test spoils one input.
class InputsStateTest : public testing::Test {
 protected:
  InputsStateTest() {
    inputs_.robot = RobotReading();
    inputs_.robot->measured_at = now_;
    inputs_.tracks_at = now_;
    inputs_.first_tracks_at = now_ - 10.0;
    inputs_.map = std::make_shared<const StaticMap>(Bounds(), StaticMap::Obstacles());
    inputs_.map_at = now_;
    inputs_.clock_at = now_;
    limits_.map = 5.0;
  }

  StopCause cause() const { return missingInput(inputs_, limits_, now_); }
  std::string text() const { return explain(cause(), inputs_); }

  InputHealth healthOf(const std::string& name) const {
    for (const InputHealth& health : inputHealth(inputs_, limits_, now_)) {
      if (health.name == name) return health;
    }
    ADD_FAILURE() << name;
    return {};
  }

  // Levels of all inputs but one, which is bad.
  void expectOnlyBad(const std::string& name) const {
    for (const InputHealth& health : inputHealth(inputs_, limits_, now_)) {
      EXPECT_EQ(health.level, health.name == name ? Level::kError : Level::kOk) << health.name;
    }
  }

  double now_ = 100.0;  // [s]
  Inputs inputs_;
  InputLimits limits_;
};

TEST_F(InputsStateTest, AllFreshIsNoCause) {
  EXPECT_EQ(cause(), StopCause::kNone);
  expectOnlyBad("");
}

TEST_F(InputsStateTest, OldOdometry) {
  inputs_.robot->measured_at = now_ - 0.49;
  EXPECT_EQ(cause(), StopCause::kNone);
  inputs_.robot->measured_at = now_ - 0.51;
  EXPECT_EQ(cause(), StopCause::kNoOdometry);
  expectOnlyBad("odometry");
}

TEST_F(InputsStateTest, EveryReasonToRefuseOdometryIsNamed) {
  inputs_.robot->measured_at = now_ - 0.6;
  for (int i = 1; i < kMessageFaults; ++i) {
    const auto fault = static_cast<MessageFault>(i);
    inputs_.odometry_traffic.noteRefusal(fault, now_ - 0.1);
    EXPECT_EQ(cause(), StopCause::kOdometryRefused);
    EXPECT_EQ(text(), std::string("odometry is refused: ") + describe(fault));
    EXPECT_STRNE(describe(fault), "");
    EXPECT_EQ(inputs_.odometry_traffic.count(fault), 1u);
  }
  EXPECT_EQ(inputs_.odometry_traffic.refusals(), static_cast<unsigned>(kMessageFaults) - 1);
}

TEST_F(InputsStateTest, ARefusalLongAgoIsNoReason) {
  inputs_.robot->measured_at = now_ - 3.0;
  inputs_.odometry_traffic.noteRefusal(MessageFault::kFuture, now_ - 2.0);
  EXPECT_EQ(cause(), StopCause::kNoOdometry);
}

TEST_F(InputsStateTest, AFewRefusedMessagesAreAWarning) {
  inputs_.odometry_traffic.noteRefusal(MessageFault::kNotFinite, now_ - 1.0);
  EXPECT_EQ(cause(), StopCause::kNone);
  EXPECT_EQ(healthOf("odometry").level, Level::kWarning);
  now_ += 4.5;
  inputs_.robot->measured_at = now_;
  EXPECT_EQ(healthOf("odometry").level, Level::kOk);
}

TEST_F(InputsStateTest, OldRefusedAndNewPeople) {
  inputs_.tracks_at = now_ - 1.1;
  EXPECT_EQ(cause(), StopCause::kNoPeople);
  expectOnlyBad("people");
  inputs_.people_traffic.noteRefusal(MessageFault::kNotFinite, now_);
  EXPECT_EQ(cause(), StopCause::kPeopleRefused);
  inputs_.tracks_at = now_;
  inputs_.first_tracks_at = now_ - 0.5;
  EXPECT_EQ(cause(), StopCause::kWatchingPeople);
  EXPECT_EQ(healthOf("people").level, Level::kWarning);
}

// A tracker of 0.8 Hz, whose age limit allows for it.
TEST_F(InputsStateTest, SlowTracksAreASeriesWithinTheirAgeLimit) {
  limits_.people = 3.0;
  const auto causeAfterTwo = [this](double period, bool is_afresh = false) {
    inputs_.tracks_at = inputs_.first_tracks_at = -1.0;
    inputs_.noteTracks(now_ - period, longestGap(limits_.people), true);
    inputs_.noteTracks(now_, longestGap(limits_.people), is_afresh);
    return cause();
  };
  EXPECT_EQ(causeAfterTwo(1.25), StopCause::kNone);
  EXPECT_EQ(causeAfterTwo(2.9), StopCause::kNone);
  EXPECT_EQ(causeAfterTwo(3.1), StopCause::kWatchingPeople);
  EXPECT_EQ(causeAfterTwo(1.25, true), StopCause::kWatchingPeople);
  limits_.people = 0.5;
  EXPECT_EQ(causeAfterTwo(0.9), StopCause::kWatchingPeople) << "not yet for a second";
  inputs_.noteTracks(now_ + 0.9, longestGap(limits_.people), false);
  now_ += 0.9;
  EXPECT_EQ(missingPeople(inputs_, limits_, now_), StopCause::kNone);
}

TEST_F(InputsStateTest, MissingOldAndRefusedMap) {
  inputs_.map_at = now_ - 5.1;
  EXPECT_EQ(cause(), StopCause::kNoMap);
  expectOnlyBad("map");
  inputs_.map_traffic.noteRefusal(MessageFault::kMalformed, now_ - 1.0);
  EXPECT_EQ(cause(), StopCause::kMapRefused);
  limits_.map = 0.0;
  EXPECT_EQ(cause(), StopCause::kNone);
  inputs_.map.reset();
  inputs_.map_at = -1.0;
  EXPECT_EQ(cause(), StopCause::kMapRefused);
}

TEST_F(InputsStateTest, AClockThatStandsStillComesFirst) {
  inputs_.clock_at = now_ - 0.6;
  inputs_.robot.reset();
  inputs_.map.reset();
  EXPECT_EQ(cause(), StopCause::kClockStandsStill);
  EXPECT_EQ(healthOf("clock").level, Level::kError);
}

TEST_F(InputsStateTest, AClockThatNobodyWatchesIsNoCause) {
  inputs_.clock_at = -1.0;
  EXPECT_EQ(cause(), StopCause::kNone);
}

TEST_F(InputsStateTest, AJumpExplainsWhatIsMissingForAWhile) {
  inputs_.first_tracks_at = now_ - 0.5;
  inputs_.jump = StopCause::kPoseJumped;
  inputs_.jump_at = now_ - 0.5;
  EXPECT_EQ(cause(), StopCause::kPoseJumped);
  inputs_.jump_at = now_ - 1.5;
  EXPECT_EQ(cause(), StopCause::kWatchingPeople);
}

TEST_F(InputsStateTest, TransformsHaveATaskOfTheirOwn) {
  EXPECT_EQ(healthOf("transforms").level, Level::kOk);
  inputs_.odometry_traffic.frame = "wheels";
  inputs_.odometry_traffic.noteRefusal(MessageFault::kOldTransform, now_ - 0.1);
  const InputHealth health = healthOf("transforms");
  EXPECT_EQ(health.level, Level::kError);
  EXPECT_NE(health.text.find("wheels"), std::string::npos);
  EXPECT_EQ(health.refused, 1u);
}

TEST(RateMeter, CountsOverTheLastEventsAndTheSilenceSince) {
  RateMeter meter;
  EXPECT_EQ(meter.rate(0.0), 0.0);
  meter.count(10.0);
  EXPECT_EQ(meter.rate(10.0), 0.0);
  for (int i = 1; i <= 200; ++i) meter.count(10.0 + 0.1 * i);
  EXPECT_NEAR(meter.rate(30.0), 10.0, 1e-6);
  EXPECT_NEAR(meter.last(), 30.0, 1e-9);
  EXPECT_LT(meter.rate(80.0), 1.0);
}

}  // namespace
}  // namespace pomdp_crowd_nav
