// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/ros/transform_feed.h"

#include <gtest/gtest.h>

#include <limits>

namespace pomdp_crowd_nav {
namespace {

TEST(TransformFeed, PassesOverStampsOfTheFarFutureOnly) {
  constexpr double kNow = 1000.0;
  EXPECT_TRUE(isTransformOfUse(kNow - 5.0, kNow));
  EXPECT_TRUE(isTransformOfUse(kNow + 1.0, kNow)) << "as a localisation stamps ahead";
  EXPECT_FALSE(isTransformOfUse(kNow + 11.0, kNow));
  const ros::Time last(std::numeric_limits<std::uint32_t>::max(), 999999999);
  EXPECT_FALSE(isTransformOfUse(last.toSec(), kNow));
}

}  // namespace
}  // namespace pomdp_crowd_nav
