// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/prior/way_out.h"

#include <gtest/gtest.h>

namespace pomdp_crowd_nav {
namespace {

StaticMap mapWith(const StaticMap::Obstacles& obstacles) {
  return StaticMap({{0.0, 0.0}, {40.0, 30.0}}, obstacles);
}

TEST(WayOutTest, LeadsOutOfADiscAndItsMarginTheShortWay) {
  StaticMap::Obstacles obstacles;
  obstacles.circles = {{{20.0, 15.0}, 4.0}};
  const LineOfSight sight(mapWith(obstacles), 2.0);
  const WayOut way_out(sight);
  for (double angle = 0.0; angle < 6.3; angle += 0.1) {
    for (const double radius : {0.5, 3.0, 4.5, 5.9}) {
      const Point place = Point(20.0, 15.0) + radius * unitVector(angle);
      const auto out = way_out.nearestFree(place);
      ASSERT_TRUE(out);
      EXPECT_TRUE(sight.isFree(*out));
      EXPECT_NEAR((*out - place).norm(), 6.0 - radius, 0.3) << "at " << place.transpose();
    }
  }
}

TEST(WayOutTest, IsHereWhereTheClearanceIsKept) {
  const LineOfSight sight(mapWith({}), 2.0);
  EXPECT_LE((*WayOut(sight).nearestFree({7.0, 8.0}) - Point(7.0, 8.0)).norm(), 0.1);
}

// Beside a corridor too narrow for the clearance, the nearest free place is behind its wall.
TEST(WayOutTest, LeadsThroughNoWall) {
  StaticMap::Obstacles obstacles;
  obstacles.polygons = {{{{0.0, 12.0}, {30.0, 12.0}}, false}, {{{0.0, 15.0}, {30.0, 15.0}}, false}};
  const LineOfSight sight(mapWith(obstacles), 2.0);
  const WayOut way_out(sight);
  EXPECT_FALSE(way_out.nearestFree({10.0, 13.4}));
  EXPECT_TRUE(way_out.nearestFree({10.0, 11.0}));
  EXPECT_TRUE(way_out.nearestFree({29.9, 13.4}));
}

// Where an obstacle touches the border, its clearance rises slowly along the way out.
TEST(WayOutTest, LeadsOutOfAWedge) {
  StaticMap::Obstacles obstacles;
  obstacles.circles = {{{30.0, 20.0}, 20.0}};
  const LineOfSight sight(mapWith(obstacles), 3.0);
  const auto out = WayOut(sight).nearestFree({26.0, 0.1});
  ASSERT_TRUE(out);
  EXPECT_LT(out->x(), 20.0);
}

TEST(WayOutTest, KnowsNoneOnAMapWithoutFreePlaces) {
  StaticMap::Obstacles obstacles;
  obstacles.circles = {{{20.0, 15.0}, 30.0}};
  const LineOfSight sight(mapWith(obstacles), 2.0);
  EXPECT_FALSE(WayOut(sight).nearestFree({10.0, 10.0}));
}

}  // namespace
}  // namespace pomdp_crowd_nav
