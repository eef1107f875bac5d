// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/ros/message_gate.h"

#include <gtest/gtest.h>

#include <limits>

namespace pomdp_crowd_nav {
namespace {

constexpr double kNow = 1000.0;

MessageFault faultAt(double stamp) { return faultOfStamp(stamp, kNow, {}, 0); }

TEST(Stamps, OfNowOfThePastAndALittleAheadAreFine) {
  EXPECT_EQ(faultAt(kNow), MessageFault::kNone);
  EXPECT_EQ(faultAt(kNow - 100.0), MessageFault::kNone);  // its age stops the robot
  EXPECT_EQ(faultAt(kNow + 0.49), MessageFault::kNone);
}

TEST(Stamps, MissingOnesAndThoseOfTheFutureAreRefused) {
  EXPECT_EQ(faultAt(0.0), MessageFault::kUnstamped);
  EXPECT_EQ(faultAt(kNow + 0.51), MessageFault::kFuture);
  EXPECT_EQ(faultAt(ros::Time(std::numeric_limits<std::uint32_t>::max(), 0).toSec()),
            MessageFault::kFuture);
}

TEST(Stamps, OneBeforeTheLastIsRefusedUnlessTheClockJumpedBetween) {
  const NewestStamp newest{3, kNow - 1.0};
  EXPECT_EQ(faultOfStamp(kNow - 2.0, kNow, newest, 3), MessageFault::kOutOfOrder);
  EXPECT_EQ(faultOfStamp(kNow - 1.0, kNow, newest, 3), MessageFault::kNone);
  EXPECT_EQ(faultOfStamp(kNow - 2.0, kNow, newest, 4), MessageFault::kNone);
}

TEST(Frames, LoseTheirLeadingSlash) {
  EXPECT_EQ(withoutSlash("/odom"), "odom");
  EXPECT_EQ(withoutSlash("odom"), "odom");
  EXPECT_EQ(withoutSlash(""), "");
  EXPECT_EQ(withoutSlash("/"), "");
}

}  // namespace
}  // namespace pomdp_crowd_nav
