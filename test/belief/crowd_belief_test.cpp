// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/belief/crowd_belief.h"

#include <gtest/gtest.h>

namespace pomdp_crowd_nav {
namespace {

const std::vector<Point> kEnds = {{0.0, 0.0}, {10.0, 0.0}};

TEST(CrowdBelief, AWalkerDoesWhatTheHypothesisSays) {
  PersonBelief person{1, {5.0, 5.0}, {0.0, 0.0}, 1.3, IntentionBelief(2), {0.0, 0.8}};
  const Pedestrian bound = walkerOf(person, 1, kEnds);
  EXPECT_EQ(bound.position, person.position);
  EXPECT_EQ(bound.destination, kEnds[1]);
  EXPECT_EQ(bound.speed, 1.3);

  const Pedestrian standing = walkerOf(person, IntentionBelief::kStanding, kEnds);
  EXPECT_EQ(standing.destination, person.position);
  EXPECT_EQ(standing.speed, 0.0);

  const Pedestrian elsewhere = walkerOf(person, IntentionBelief::kElsewhere, kEnds);
  EXPECT_DOUBLE_EQ(elsewhere.destination.x(), 5.0);
  EXPECT_GT(elsewhere.destination.y(), 500.0);
  EXPECT_DOUBLE_EQ(elsewhere.speed, 0.8);

  person.walk = Point(0.0, 0.0);
  EXPECT_EQ(walkerOf(person, IntentionBelief::kElsewhere, kEnds).destination, person.position);
}

}  // namespace
}  // namespace pomdp_crowd_nav
