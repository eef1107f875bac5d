// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "guarded_drive.h"

namespace pomdp_crowd_nav {
namespace {

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

}  // namespace
}  // namespace pomdp_crowd_nav
