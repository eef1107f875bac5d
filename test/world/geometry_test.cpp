// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/world/geometry.h"

#include <gtest/gtest.h>

#include <cmath>

namespace pomdp_crowd_nav {
namespace {

TEST(GeometryTest, WrapsAnglesIntoTheHalfOpenTurn) {
  EXPECT_DOUBLE_EQ(wrapAngle(0.5), 0.5);
  EXPECT_DOUBLE_EQ(wrapAngle(M_PI), M_PI);
  EXPECT_DOUBLE_EQ(wrapAngle(-M_PI), M_PI);
  EXPECT_DOUBLE_EQ(wrapAngle(3.0 * M_PI), M_PI);
  EXPECT_NEAR(wrapAngle(2.0 * M_PI + 0.25), 0.25, 1e-15);
  EXPECT_NEAR(wrapAngle(-1.75 * M_PI), 0.25 * M_PI, 1e-15);
  EXPECT_NEAR(wrapAngle(100.0 * M_PI - 0.1), -0.1, 1e-12);
}

TEST(GeometryTest, UnitVectorAndBearingAreInverse) {
  EXPECT_NEAR((unitVector(M_PI / 2.0) - Point(0.0, 1.0)).norm(), 0.0, 1e-15);
  for (double angle = -3.1; angle < 3.1; angle += 0.2) {
    const Point from(2.0, -1.0);
    EXPECT_NEAR(bearing(from, from + 3.0 * unitVector(angle)), angle, 1e-12);
  }
  EXPECT_DOUBLE_EQ(bearing({2.0, 1.0}, {2.0, 1.0}), 0.0);
}

TEST(GeometryTest, DistanceToSegmentIsToItsInsideOrItsEnds) {
  const Point a(0.0, 0.0), b(4.0, 0.0);
  EXPECT_DOUBLE_EQ(distanceToSegment({1.0, 2.0}, a, b), 2.0);
  EXPECT_DOUBLE_EQ(distanceToSegment({-3.0, 4.0}, a, b), 5.0);
  EXPECT_DOUBLE_EQ(distanceToSegment({7.0, -4.0}, a, b), 5.0);
  EXPECT_DOUBLE_EQ(distanceToSegment({3.0, 0.0}, a, b), 0.0);
  EXPECT_DOUBLE_EQ(distanceToSegment({3.0, 4.0}, a, a), 5.0);
}

TEST(GeometryTest, EvenOddRuleTellsInsideFromOutside) {
  // An L: the square [0, 2]^2 without its upper right quarter.
  const std::vector<Point> l_shape = {{0.0, 0.0}, {2.0, 0.0}, {2.0, 1.0},
                                      {1.0, 1.0}, {1.0, 2.0}, {0.0, 2.0}};
  EXPECT_TRUE(isInsidePolygon({0.5, 0.5}, l_shape));
  EXPECT_TRUE(isInsidePolygon({1.5, 0.5}, l_shape));
  EXPECT_TRUE(isInsidePolygon({0.5, 1.0}, l_shape));  // level with a corner
  EXPECT_FALSE(isInsidePolygon({1.5, 1.5}, l_shape));
  EXPECT_FALSE(isInsidePolygon({-0.5, 1.0}, l_shape));
  EXPECT_FALSE(isInsidePolygon({-0.5, 0.0}, l_shape));
  const std::vector<Point> clockwise(l_shape.rbegin(), l_shape.rend());
  EXPECT_TRUE(isInsidePolygon({0.5, 0.5}, clockwise));
  EXPECT_FALSE(isInsidePolygon({1.5, 1.5}, clockwise));
}

}  // namespace
}  // namespace pomdp_crowd_nav
