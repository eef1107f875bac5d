// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/control/progress_watch.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace pomdp_crowd_nav {
namespace {

ProgressWatch watch(double blocked, double abort) {
  ProgressWatch::Params params;
  params.distance = 0.5;
  params.blocked_timeout = blocked;
  params.abort_timeout = abort;
  ProgressWatch progress(params);
  progress.begin(100.0);
  return progress;
}

TEST(ProgressWatch, StandingStillIsNoProgress) {
  ProgressWatch progress = watch(10.0, 30.0);
  for (double now = 100.0; now < 109.9; now += 0.5) {
    progress.see(20.0, now);
    EXPECT_FALSE(progress.isBlocked(now)) << now;
  }
  EXPECT_TRUE(progress.isBlocked(110.0));
  EXPECT_FALSE(progress.isHopeless(129.9));
  EXPECT_TRUE(progress.isHopeless(130.0));
}

TEST(ProgressWatch, OnlyAShorterWayThanEverIsProgress) {
  ProgressWatch progress = watch(10.0, 0.0);
  progress.see(20.0, 100.0);
  progress.see(25.0, 104.0);  // round somebody
  progress.see(20.2, 108.0);  // and back
  progress.see(19.6, 109.0);  // too little
  EXPECT_TRUE(progress.isBlocked(110.0));
  progress.see(19.4, 111.0);
  EXPECT_FALSE(progress.isBlocked(120.9));
  EXPECT_TRUE(progress.isBlocked(121.0));
}

TEST(ProgressWatch, SlowProgressAddsUp) {
  ProgressWatch progress = watch(10.0, 0.0);
  for (double now = 100.0; now < 200.0; now += 1.0) {
    progress.see(20.0 - 0.1 * (now - 100.0), now);
    EXPECT_FALSE(progress.isBlocked(now)) << now;
  }
}

TEST(ProgressWatch, HeldTimeCountsForNothing) {
  ProgressWatch progress = watch(10.0, 0.0);
  progress.see(20.0, 100.0);
  progress.hold(500.0);
  EXPECT_FALSE(progress.isBlocked(509.9));
  EXPECT_TRUE(progress.isBlocked(510.0));
}

TEST(ProgressWatch, AnotherWayIsNeitherProgressNorComparedWithTheOld) {
  ProgressWatch progress = watch(10.0, 0.0);
  progress.see(20.0, 100.0);
  progress.takeAnotherWay();
  progress.see(50.0, 105.0);
  EXPECT_TRUE(progress.isBlocked(110.0)) << "a longer way is no progress";
  progress.see(49.0, 111.0);
  EXPECT_FALSE(progress.isBlocked(112.0)) << "getting on along it is";
}

TEST(ProgressWatch, ZeroTurnsATimeoutOff) {
  ProgressWatch progress = watch(0.0, 0.0);
  EXPECT_FALSE(progress.isBlocked(1e6));
  EXPECT_FALSE(progress.isHopeless(1e6));
}

TEST(ProgressWatch, RejectsParametersThatMakeNoSense) {
  for (const ProgressWatch::Params& bad :
       {ProgressWatch::Params{0.0, 1.0, 1.0}, ProgressWatch::Params{0.5, -1.0, 1.0},
        ProgressWatch::Params{0.5, 1.0, -1.0}}) {
    EXPECT_THROW(ProgressWatch{bad}, std::invalid_argument);
  }
}

}  // namespace
}  // namespace pomdp_crowd_nav
