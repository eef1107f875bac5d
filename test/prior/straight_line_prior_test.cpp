// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/prior/straight_line_prior.h"

#include <gtest/gtest.h>

#include <cmath>

namespace pomdp_crowd_nav {
namespace {

TEST(StraightLinePriorTest, PointsAtTheGoalWhateverTheHeading) {
  const StraightLinePrior prior({4.0, 3.0});
  EXPECT_DOUBLE_EQ(*prior.directionAt({{1.0, 0.0}, 2.0}), M_PI / 4.0);
  EXPECT_DOUBLE_EQ(*prior.directionAt({{4.0, 9.0}, 0.0}), -M_PI / 2.0);
  EXPECT_DOUBLE_EQ(prior.distanceToGoal({0.0, 0.0}), 5.0);
  EXPECT_DOUBLE_EQ(prior.distanceToGoal({4.0, 3.0}), 0.0);
}

}  // namespace
}  // namespace pomdp_crowd_nav
