// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/ros/clock_watch.h"

#include <gtest/gtest.h>

namespace pomdp_crowd_nav {
namespace {

TEST(ClockWatch, ATickingClockNeitherJumpsNorStands) {
  ClockWatch watch(50.0);
  for (int i = 1; i < 100; ++i) {
    const ClockWatch::Look look = watch.look(1000.0 + 0.05 * i, 50.0 + 0.05 * i);
    EXPECT_FALSE(look.jumped);
    EXPECT_DOUBLE_EQ(look.moved_at, 50.0 + 0.05 * i);
  }
  EXPECT_EQ(watch.epoch(), 0);
}

TEST(ClockWatch, BeforeTheFirstTimeItStandsAndTheFirstTimeIsNoJump) {
  ClockWatch watch(50.0);
  EXPECT_DOUBLE_EQ(watch.look(0.0, 55.0).moved_at, 50.0);
  const ClockWatch::Look look = watch.look(1.7e9, 56.0);
  EXPECT_FALSE(look.jumped);
  EXPECT_DOUBLE_EQ(look.moved_at, 56.0);
}

TEST(ClockWatch, AJumpBackIsSeenOnceAndTimeGoesOnFromThere) {
  ClockWatch watch(50.0);
  watch.look(1000.0, 50.0);
  EXPECT_FALSE(watch.look(999.95, 50.1).jumped);  // set back a little
  EXPECT_TRUE(watch.look(990.0, 50.2).jumped);
  const ClockWatch::Look look = watch.look(990.1, 50.3);
  EXPECT_FALSE(look.jumped);
  EXPECT_EQ(look.epoch, 1);
  EXPECT_DOUBLE_EQ(look.moved_at, 50.3);
}

TEST(ClockWatch, AJumpAheadIsSeenOnce) {
  ClockWatch watch(50.0);
  watch.look(1000.0, 50.0);
  EXPECT_FALSE(watch.look(1001.5, 50.1).jumped);  // a fast simulation
  EXPECT_TRUE(watch.look(1011.6, 50.2).jumped);
  EXPECT_FALSE(watch.look(1011.7, 50.3).jumped);
}

TEST(ClockWatch, TimeThatWentOnUnseenIsNoJump) {
  ClockWatch watch(50.0);
  watch.look(1000.0, 50.0);
  EXPECT_FALSE(watch.look(1060.0, 110.0).jumped);
}

TEST(ClockWatch, SaysSinceWhenItStands) {
  ClockWatch watch(50.0);
  watch.look(1000.0, 50.0);
  watch.look(1000.1, 50.1);
  EXPECT_DOUBLE_EQ(watch.look(1000.1, 58.0).moved_at, 50.1);
}

}  // namespace
}  // namespace pomdp_crowd_nav
