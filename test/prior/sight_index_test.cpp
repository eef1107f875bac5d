// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/prior/sight_index.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

namespace pomdp_crowd_nav {
namespace {

StaticMap crowdedMap() {
  StaticMap::Obstacles obstacles;
  obstacles.circles = {{{12.0, 15.0}, 2.0}, {{26.0, 10.0}, 3.0}};
  obstacles.polygons = {{{{20.0, 18.0}, {30.0, 20.0}, {24.0, 26.0}}, true},
                        {{{8.0, 0.0}, {8.0, 9.0}}, false}};
  return StaticMap({{0.0, 0.0}, {40.0, 30.0}}, obstacles);
}

std::vector<Waypoint> someWaypoints(const LineOfSight& sight) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> x(0.0, 40.0), y(0.0, 30.0), detour(1.0, 1.3);
  const Point goal(38.0, 15.0);
  std::vector<Waypoint> waypoints{{goal, 0.0}};
  while (waypoints.size() < 200) {
    const Point place(x(random), y(random));
    if (!sight.isFree(place)) continue;
    waypoints.push_back({place, detour(random) * (goal - place).norm()});
  }
  return waypoints;
}

std::optional<int> bruteForceBest(const LineOfSight& sight, const std::vector<Waypoint>& waypoints,
                                  const Point& from) {
  std::optional<int> best;
  double shortest = std::numeric_limits<double>::infinity();
  for (size_t i = 0; i < waypoints.size(); ++i) {
    const double way = (waypoints[i].position - from).norm() + waypoints[i].distance_to_goal;
    if (way >= shortest || !sight.isClear(from, waypoints[i].position)) continue;
    shortest = way;
    best = static_cast<int>(i);
  }
  return best;
}

TEST(SightIndexTest, FindsWhatLookingAtEveryWaypointFinds) {
  for (const double clearance : {0.3, 1.5}) {
    const LineOfSight sight(crowdedMap(), clearance);
    const std::vector<Waypoint> waypoints = someWaypoints(sight);
    const SightIndex index(sight, waypoints);
    std::mt19937 random(6);
    std::uniform_real_distribution<double> x(0.0, 40.0), y(0.0, 30.0);
    for (int i = 0; i < 2000; ++i) {
      const Point from(x(random), y(random));
      if (!sight.isFree(from)) continue;
      ASSERT_EQ(index.bestFrom(from), bruteForceBest(sight, waypoints, from))
          << "from " << from.transpose();
    }
  }
}

TEST(SightIndexTest, LeavesTheWaypointOnWhichOneStands) {
  const LineOfSight sight(StaticMap({{0.0, 0.0}, {40.0, 30.0}}, {}), 1.0);
  const SightIndex index(sight, {{{30.0, 10.0}, 0.0}, {{20.0, 10.0}, 10.0}});
  EXPECT_EQ(index.bestFrom({20.0, 10.0}), 0);
  EXPECT_EQ(index.bestFrom({30.0, 10.0}), 0) << "the goal";
}

TEST(SightIndexTest, SaysNothingInsideTheClearanceAndOffTheMap) {
  const LineOfSight sight(crowdedMap(), 1.5);
  const SightIndex index(sight, someWaypoints(sight));
  EXPECT_FALSE(index.bestFrom({12.0, 15.0}));
  EXPECT_FALSE(index.bestFrom({12.0, 18.0}));
  EXPECT_FALSE(index.bestFrom({-0.1, 15.0}));
  EXPECT_TRUE(index.bestFrom({0.0, 15.0}));
}

}  // namespace
}  // namespace pomdp_crowd_nav
