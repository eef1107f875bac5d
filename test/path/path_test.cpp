// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/path/path.h"

#include <gtest/gtest.h>

#include <cmath>

namespace pomdp_crowd_nav {
namespace {

// East, then north after a turn in place, then a quarter of a circle to the west.
Path hook() {
  return Path({1.0, 2.0}, {{0.0, 0.0, 2.0}, {M_PI / 2.0, 0.0, 1.0}, {M_PI / 2.0, M_PI / 2.0, 3.0}});
}

TEST(Path, GoesThroughTheEndsOfItsLegs) {
  const Path path = hook();
  EXPECT_DOUBLE_EQ(path.length(), 6.0);
  EXPECT_LT((path.positionAt(0.0) - Point(1.0, 2.0)).norm(), 1e-12);
  EXPECT_LT((path.positionAt(1.5) - Point(2.5, 2.0)).norm(), 1e-12);
  EXPECT_LT((path.positionAt(3.0) - Point(3.0, 3.0)).norm(), 1e-12);
  const double radius = 3.0 / (M_PI / 2.0);
  EXPECT_LT((path.positionAt(6.0) - Point(3.0 - radius, 3.0 + radius)).norm(), 1e-12);
  EXPECT_EQ(path.positionAt(-1.0), path.positionAt(0.0));
  EXPECT_EQ(path.positionAt(7.0), path.positionAt(6.0));
}

TEST(Path, HeadingsJumpBetweenLegsAndTurnOnArcs) {
  const Path path = hook();
  EXPECT_DOUBLE_EQ(path.headingAt(1.999), 0.0);
  EXPECT_DOUBLE_EQ(path.headingAt(2.0), M_PI / 2.0);
  EXPECT_NEAR(path.headingAt(4.5), 0.75 * M_PI, 1e-12);
  EXPECT_NEAR(path.headingAt(99.0), M_PI, 1e-12);
}

TEST(Path, ItsRestIsTheSameWay) {
  const Path path = hook();
  for (const double cut : {0.0, 0.7, 2.0, 2.4, 3.0, 4.7, 5.999}) {
    const Path rest = path.from(cut);
    ASSERT_NEAR(rest.length(), 6.0 - cut, 1e-9);
    for (double s = 0.0; s < rest.length(); s += 0.13) {
      ASSERT_LT((rest.positionAt(s) - path.positionAt(cut + s)).norm(), 1e-9) << cut << ' ' << s;
    }
  }
  const Path nothing = path.from(6.0);
  EXPECT_TRUE(nothing.isEmpty());
  EXPECT_EQ(nothing.positionAt(0.0), path.positionAt(6.0));
}

TEST(Path, ItsFirstLegsAreTheSameWay) {
  const Path path = hook();
  for (const double cut : {0.5, 2.0, 2.9, 5.0, 9.0}) {
    const Path first(path.positionAt(0.0), path.firstLegs(cut));
    EXPECT_NEAR(first.length(), std::min(cut, 6.0), 1e-9);
    EXPECT_LT((first.positionAt(cut) - path.positionAt(cut)).norm(), 1e-9);
  }
  EXPECT_TRUE(path.firstLegs(0.0).empty());
}

TEST(Path, FindsTheNearestPlaceWithinReach) {
  const Path path = hook();
  EXPECT_NEAR(path.nearestTo({2.2, 1.8}, 4.0), 1.2, 0.01);
  EXPECT_NEAR(path.nearestTo(path.positionAt(5.0), 6.0), 5.0, 0.01);
  EXPECT_NEAR(path.nearestTo(path.positionAt(5.0), 3.0), 3.0, 0.01);
  EXPECT_EQ(path.nearestTo({-5.0, 2.0}, 6.0), 0.0);
}

TEST(Path, OfNothingIsNowhereToGo) {
  const Path path({3.0, 4.0}, {});
  EXPECT_TRUE(path.isEmpty());
  EXPECT_EQ(path.length(), 0.0);
  EXPECT_EQ(path.positionAt(1.0), Point(3.0, 4.0));
  EXPECT_TRUE(path.firstLegs(2.0).empty());
  EXPECT_EQ(Path().length(), 0.0);
}

}  // namespace
}  // namespace pomdp_crowd_nav
