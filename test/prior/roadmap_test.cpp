// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/prior/roadmap.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>

namespace pomdp_crowd_nav {
namespace {

StaticMap discMap() {
  StaticMap::Obstacles obstacles;
  obstacles.circles = {{{20.0, 15.0}, 4.0}, {{32.0, 22.0}, 3.0}};
  return StaticMap({{0.0, 0.0}, {40.0, 30.0}}, obstacles);
}

// Two rooms with a door of 5 m between them, at x = 20.
StaticMap roomsMap(double door_end) {
  StaticMap::Obstacles obstacles;
  obstacles.polygons = {{{{20.0, 0.0}, {20.0, 10.0}}, false},
                        {{{20.0, door_end}, {20.0, 30.0}}, false}};
  return StaticMap({{0.0, 0.0}, {40.0, 30.0}}, obstacles);
}

Roadmap::Params smallParams() {
  Roadmap::Params params;
  params.milestones = 150;
  params.neighbours = 6;
  params.spacing = 1.0;
  params.clearance = 2.0;
  return params;
}

TEST(RoadmapTest, MilestonesAndEdgesKeepTheirDistances) {
  const StaticMap map = discMap();
  const Roadmap::Params params = smallParams();
  const Roadmap roadmap(map, params);
  const std::vector<Point>& milestones = roadmap.milestones();
  ASSERT_EQ(milestones.size(), 150U);
  for (size_t i = 0; i < milestones.size(); ++i) {
    EXPECT_TRUE(map.bounds().contains(milestones[i]));
    for (size_t j = 0; j < i; ++j) EXPECT_GE((milestones[i] - milestones[j]).norm(), 1.0);
  }
  for (const Roadmap::Edge& edge : roadmap.edges()) {
    const Point from = milestones[edge.from];
    const Point way = milestones[edge.to] - from;
    EXPECT_DOUBLE_EQ(edge.length, way.norm());
    for (double share = 0.0; share <= 1.0; share += 0.002) {
      ASSERT_GE(map.clearance(from + share * way), params.clearance - 1e-3);
    }
  }
}

TEST(RoadmapTest, EveryMilestoneIsJoinedToItsNearestNeighbours) {
  const StaticMap map({{0.0, 0.0}, {40.0, 30.0}}, {});
  const Roadmap roadmap(map, smallParams());
  // Each to 6 earlier ones, the first ones to as many as there were.
  EXPECT_EQ(roadmap.edges().size(), 6U * 150U - (6U + 5U + 4U + 3U + 2U + 1U));
}

TEST(RoadmapTest, TheSeedMakesTheRoadmap) {
  const StaticMap map = discMap();
  Roadmap::Params params = smallParams();
  const Roadmap first(map, params);
  const Roadmap again(map, params);
  EXPECT_EQ(first.milestones(), again.milestones());
  ASSERT_EQ(first.edges().size(), again.edges().size());
  for (size_t i = 0; i < first.edges().size(); ++i) {
    EXPECT_EQ(first.edges()[i].from, again.edges()[i].from);
    EXPECT_EQ(first.edges()[i].to, again.edges()[i].to);
  }
  params.seed = 12;
  EXPECT_NE(Roadmap(map, params).milestones(), first.milestones());
}

// Relaxes every edge until nothing changes.
std::vector<double> bruteForceDistances(const Roadmap& roadmap, std::vector<double> distances) {
  for (bool changed = true; changed;) {
    changed = false;
    for (const Roadmap::Edge& edge : roadmap.edges()) {
      for (const auto& [from, to] :
           {std::pair(edge.from, edge.to), std::pair(edge.to, edge.from)}) {
        if (distances[from] + edge.length >= distances[to]) continue;
        distances[to] = distances[from] + edge.length;
        changed = true;
      }
    }
  }
  return distances;
}

TEST(RoadmapTest, DistancesAreThoseOfTheShortestPaths) {
  const Roadmap roadmap(discMap(), smallParams());
  const Point goal(37.0, 8.0);
  const std::vector<double> found = roadmap.distancesTo(goal);
  // The goal's own edges end at the milestones that are no farther by path than by air.
  std::vector<double> start(found.size(), std::numeric_limits<double>::infinity());
  int joined = 0;
  for (size_t i = 0; i < found.size(); ++i) {
    const double straight = (roadmap.milestones()[i] - goal).norm();
    ASSERT_GE(found[i], straight - 1e-9);
    if (found[i] > straight + 1e-9) continue;
    start[i] = straight;
    ++joined;
  }
  EXPECT_GE(joined, 6);
  const std::vector<double> expected = bruteForceDistances(roadmap, start);
  for (size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i], expected[i], 1e-9);
}

TEST(RoadmapTest, RoomsAreJoinedThroughTheirDoor) {
  const Roadmap roadmap(roomsMap(15.0), smallParams());
  for (const double distance : roadmap.distancesTo({37.0, 25.0})) {
    EXPECT_TRUE(std::isfinite(distance));
  }
}

TEST(RoadmapTest, ARoomWithoutADoorHasNoWay) {
  const Roadmap roadmap(roomsMap(10.0), smallParams());
  const std::vector<double> distances = roadmap.distancesTo({37.0, 25.0});
  for (size_t i = 0; i < distances.size(); ++i) {
    EXPECT_EQ(std::isfinite(distances[i]), roadmap.milestones()[i].x() > 20.0);
  }
}

TEST(RoadmapTest, EndsWhereThereIsNoRoomForMoreMilestones) {
  Roadmap::Params params = smallParams();
  params.spacing = 10.0;
  const Roadmap roadmap(discMap(), params);
  EXPECT_GE(roadmap.milestones().size(), 5U);
  EXPECT_LE(roadmap.milestones().size(), 30U);
}

std::string rejection(const std::function<void()>& action) {
  try {
    action();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "accepted";
}

TEST(RoadmapTest, AGoalOutOfSightIsNamed) {
  StaticMap::Obstacles obstacles;
  obstacles.circles = {{{20.0, 15.0}, 30.0}};
  const Roadmap roadmap(StaticMap({{0.0, 0.0}, {40.0, 30.0}}, obstacles), smallParams());
  EXPECT_TRUE(roadmap.milestones().empty());
  EXPECT_EQ(rejection([&] {
              roadmap.distancesTo({1.5, 2.5});
            }),
            "goal (1.5, 2.5) cannot be joined to the roadmap: none of its 0 milestones is in "
            "sight, 2 m clear of obstacles");
}

TEST(RoadmapTest, ParametersOutOfRangeAreRefused) {
  const auto refusal = [](const std::function<void(Roadmap::Params&)>& change) {
    Roadmap::Params params = smallParams();
    change(params);
    return rejection([&] { Roadmap(discMap(), params); });
  };
  EXPECT_EQ(refusal([](Roadmap::Params& p) { p.milestones = 0; }),
            "prior.milestones must be between 1 and 100000, got 0");
  EXPECT_EQ(refusal([](Roadmap::Params& p) { p.neighbours = 0; }),
            "prior.neighbours must be between 1 and 1000, got 0");
  EXPECT_EQ(refusal([](Roadmap::Params& p) { p.spacing = -0.5; }),
            "prior.milestone_spacing must be at least 0, got -0.5");
  EXPECT_EQ(refusal([](Roadmap::Params& p) { p.seed = -1; }),
            "prior.seed must be at least 0, got -1");
}

TEST(RoadmapTest, KnowsTheMapAndTheParametersItIsOf) {
  const Roadmap::Params params = smallParams();
  const Roadmap roadmap(discMap(), params);
  EXPECT_TRUE(roadmap.isOf(discMap(), params));
  EXPECT_FALSE(roadmap.isOf(roomsMap(15.0), params));
  Roadmap::Params other = params;
  other.clearance = 2.1;
  EXPECT_FALSE(roadmap.isOf(discMap(), other));
  StaticMap::Obstacles obstacles = discMap().obstacles();
  obstacles.grid = OccupancyGrid{{0.0, 0.0}, 1.0, 2, 1, {0, 1}};
  const StaticMap with_grid(discMap().bounds(), obstacles);
  EXPECT_FALSE(roadmap.isOf(with_grid, params));
  EXPECT_TRUE(Roadmap(with_grid, params).isOf(with_grid, params));
}

}  // namespace
}  // namespace pomdp_crowd_nav
