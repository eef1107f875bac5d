// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/prior/line_of_sight.h"

#include <gtest/gtest.h>

#include <random>

namespace pomdp_crowd_nav {
namespace {

constexpr double kClearance = 2.0;  // [m]

StaticMap discMap() {
  StaticMap::Obstacles obstacles;
  obstacles.circles = {{{20.0, 15.0}, 4.0}};
  return StaticMap({{0.0, 0.0}, {40.0, 30.0}}, obstacles);
}

StaticMap wallMap() {
  StaticMap::Obstacles obstacles;
  obstacles.polygons = {{{{20.0, 0.0}, {20.0, 20.0}}, false}};
  return StaticMap({{0.0, 0.0}, {40.0, 30.0}}, obstacles);
}

TEST(LineOfSightTest, AWayThatKeepsTheClearanceIsClear) {
  const LineOfSight sight(discMap(), kClearance);
  EXPECT_TRUE(sight.isClear({2.0, 21.01}, {38.0, 21.01}));
  EXPECT_FALSE(sight.isClear({2.0, 20.99}, {38.0, 20.99}));
  EXPECT_FALSE(sight.isClear({2.0, 15.0}, {38.0, 15.0}));
  EXPECT_TRUE(sight.isClear({5.0, 5.0}, {5.0, 5.0}));
}

TEST(LineOfSightTest, AWallOfNoThicknessBlocksAlsoWithoutClearance) {
  const LineOfSight sight(wallMap(), 0.0);
  EXPECT_FALSE(sight.isClear({2.0, 10.0}, {38.0, 11.0}));
  EXPECT_TRUE(sight.isClear({2.0, 20.5}, {38.0, 20.5}));
}

TEST(LineOfSightTest, AnEndInsideTheClearanceIsLeftSteadily) {
  const LineOfSight sight(wallMap(), kClearance);
  const Point beside_the_wall(19.0, 10.0);
  EXPECT_TRUE(sight.isClear({5.0, 10.0}, beside_the_wall));
  EXPECT_TRUE(sight.isClear(beside_the_wall, {5.0, 10.0}));
  EXPECT_TRUE(sight.isClear({15.0, 19.0}, beside_the_wall));   // rises by 0.44 m a metre
  EXPECT_FALSE(sight.isClear({18.0, 20.0}, beside_the_wall));  // by 0.1
  EXPECT_FALSE(sight.isClear({35.0, 10.0}, beside_the_wall));
}

// A robot that drives toward a place in sight does not lose it out of sight.
TEST(LineOfSightTest, TheRestOfAClearWayIsClear) {
  const LineOfSight sight(discMap(), kClearance);
  std::mt19937 random(2);
  std::uniform_real_distribution<double> x(0.0, 40.0), y(0.0, 30.0), share(0.0, 1.0);
  int clear = 0;
  for (int i = 0; i < 5000; ++i) {
    const Point from(x(random), y(random));
    const Point to(x(random), y(random));
    if (!sight.isFree(from) || !sight.isFree(to) || !sight.isClear(from, to)) continue;
    ++clear;
    ASSERT_TRUE(sight.isClear(from + share(random) * (to - from), to));
  }
  EXPECT_GT(clear, 1000);
}

TEST(LineOfSightTest, TheViewFromADiscIsThatFromEachOfItsPoints) {
  const LineOfSight sight(discMap(), kClearance);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> x(0.0, 40.0), y(0.0, 30.0), angle(0.0, 6.3),
      unit(0.0, 1.0);
  int clear = 0;
  int blocked = 0;
  for (int i = 0; i < 3000; ++i) {
    const Circle disc{{x(random), y(random)}, 5.0 * unit(random)};
    const Point to(x(random), y(random));
    if (!sight.isFree(to)) continue;
    const auto view = sight.viewFrom(disc, to);
    clear += view == LineOfSight::View::kClear ? 1 : 0;
    blocked += view == LineOfSight::View::kBlocked ? 1 : 0;
    for (int j = 0; j < 20; ++j) {
      const Point from = disc.center + disc.radius * unitVector(angle(random));
      if (!sight.isFree(from, LineOfSight::kShortfall)) {
        ASSERT_NE(view, LineOfSight::View::kClear);
      } else if (view != LineOfSight::View::kUncertain) {
        ASSERT_EQ(sight.isClear(from, to), view == LineOfSight::View::kClear);
      }
    }
  }
  EXPECT_GT(clear, 500);
  EXPECT_GT(blocked, 100);
}

}  // namespace
}  // namespace pomdp_crowd_nav
