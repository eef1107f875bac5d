// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/params/closest_name.h"

#include <gtest/gtest.h>

namespace pomdp_crowd_nav {
namespace {

const std::vector<std::string> kPlanners{"2d_fmm", "2d_prm", "2d_straight", "1d_astar"};

TEST(ClosestName, IsTheNearestOne) {
  EXPECT_EQ(closestName("2d_fmn", kPlanners), "2d_fmm");
  EXPECT_EQ(closestName("fmm", {"2d_fmm_long", "2d_fmm"}), "2d_fmm") << "a part of both";
  EXPECT_EQ(closestName("2d_strait", kPlanners), "2d_straight");
  EXPECT_EQ(closestName("1D_ASTAR", kPlanners), "1d_astar") << "case counts for nothing";
  EXPECT_EQ(closestName("2d_prm", kPlanners), "2d_prm");
}

TEST(ClosestName, IsNothingWhereNoneCanBeMeant) {
  EXPECT_EQ(closestName("teleport", kPlanners), "");
  EXPECT_EQ(closestName("", kPlanners), "");
  EXPECT_EQ(closestName("x", {"a", "bc"}), "") << "not a letter is left of it";
  EXPECT_EQ(closestName("anything", {}), "");
}

TEST(ClosestName, EndsAMessage) {
  EXPECT_EQ(didYouMean("2d_fmn", kPlanners), ", did you mean '2d_fmm'?");
  EXPECT_EQ(didYouMean("teleport", kPlanners), "");
  EXPECT_EQ(commaSeparated(kPlanners), "2d_fmm, 2d_prm, 2d_straight, 1d_astar");
  EXPECT_EQ(commaSeparated({}), "");
}

}  // namespace
}  // namespace pomdp_crowd_nav
