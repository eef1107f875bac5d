// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "guarded_drive.h"

namespace pomdp_crowd_nav {
namespace {

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

}  // namespace
}  // namespace pomdp_crowd_nav
