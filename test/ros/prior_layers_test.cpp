// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/ros/prior_layers.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "marker_checks.h"
#include "pomdp_crowd_nav/prior/fast_marching_prior.h"
#include "pomdp_crowd_nav/world/static_map.h"

namespace pomdp_crowd_nav {
namespace {

using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

// A disc in the middle, and a box that nobody gets into.
StaticMap smallMap() {
  StaticMap::Obstacles obstacles;
  obstacles.circles.push_back({Point(20.0, 10.0), 3.0});
  return StaticMap({Point(0.0, 0.0), Point(40.0, 20.0)}, obstacles);
}

PriorParams priorParams() {
  PriorParams params;
  params.clearance = 1.0;
  params.extra_clearance = 0.0;
  return params;
}

NavigationField fieldOf(const StaticMap& map, double resolution) {
  const FastMarchingPrior prior(map, Point(38.0, 10.0), priorParams());
  return NavigationField(prior, map, resolution);
}

int shadeAt(const nav_msgs::OccupancyGrid& grid, double x, double y) {
  const auto column = static_cast<size_t>((x - grid.info.origin.position.x) / grid.info.resolution);
  const auto row = static_cast<size_t>((y - grid.info.origin.position.y) / grid.info.resolution);
  return grid.data.at(row * grid.info.width + column);
}

TEST(ArrivalTimeGrid, GrowsWithTheWayAndMarksObstaclesAndMargin) {
  const StaticMap map = smallMap();
  const auto grid = arrivalTimeGrid(fieldOf(map, 0.2), 1.0, std_msgs::Header());
  ASSERT_EQ(grid.data.size(), grid.info.width * grid.info.height);
  EXPECT_DOUBLE_EQ(grid.info.origin.orientation.w, 1.0);
  EXPECT_EQ(grid.info.width, 200u);
  EXPECT_EQ(shadeAt(grid, 38.0, 10.0), 1);
  EXPECT_NEAR(shadeAt(grid, 28.0, 10.0), 1.0 + 97.0 * 10.0 / 38.9, 2.0);
  EXPECT_GE(shadeAt(grid, 0.5, 10.0), 96);
  EXPECT_LE(*std::max_element(grid.data.begin(), grid.data.end()), 100);
  EXPECT_EQ(shadeAt(grid, 20.0, 10.0), 100);
  EXPECT_EQ(shadeAt(grid, 20.0, 13.5), 99);
  EXPECT_LT(shadeAt(grid, 20.0, 14.5), 98);
}

TEST(ArrivalTimeGrid, ALargeTableIsShownMoreCoarsely) {
  const StaticMap map = smallMap();
  const auto grid = arrivalTimeGrid(fieldOf(map, 0.02), 1.0, std_msgs::Header());
  EXPECT_LE(grid.data.size(), static_cast<size_t>(kMaxArrivalCells));
  EXPECT_NEAR(grid.info.resolution, 0.04, 1e-6);
  EXPECT_NEAR(grid.info.resolution * static_cast<float>(grid.info.width), 40.0, 0.1);
  EXPECT_EQ(shadeAt(grid, 38.0, 10.0), 1);
  EXPECT_EQ(shadeAt(grid, 20.0, 10.0), 100);
}

RoadmapPrior roadmapPrior(int milestones, double spacing) {
  PriorParams params = priorParams();
  params.milestones = milestones;
  params.milestone_spacing = spacing;
  return RoadmapPrior(smallMap(), Point(38.0, 10.0), params);
}

TEST(RoadmapMarkers, EveryMilestoneWithAWayHasOneOnTheTree) {
  const RoadmapPrior prior = roadmapPrior(60, 1.0);
  const MarkerArray array = roadmapMarkers(prior, 0.5, std_msgs::Header());
  expectSound(array);
  const size_t milestones = prior.roadmap()->milestones().size();
  EXPECT_EQ(listOf(array, "milestones").points.size(), milestones);
  EXPECT_EQ(listOf(array, "edges").points.size(), 2 * prior.roadmap()->edges().size());
  const Marker ways = listOf(array, "shortest_ways");
  EXPECT_GE(ways.points.size(), 2 * milestones);
  EXPECT_LT(ways.points.size(), 2 * milestones + 10) << "a tree, but for ways of equal length";
  const bool leads_to_goal = std::any_of(ways.points.begin(), ways.points.end(),
                                         [](const auto& p) { return p.x == 38.0 && p.y == 10.0; });
  EXPECT_TRUE(leads_to_goal);
}

TEST(RoadmapMarkers, OfALargeRoadmapEdgesAreLeftOutButNoShortestWay) {
  const RoadmapPrior prior = roadmapPrior(2000, 0.1);
  ASSERT_GT(prior.roadmap()->edges().size(), kMaxRoadmapEdges);
  const MarkerArray array = roadmapMarkers(prior, 0.5, std_msgs::Header());
  expectSound(array);
  const size_t milestones = prior.roadmap()->milestones().size();
  EXPECT_GT(listOf(array, "edges").points.size(), kMaxRoadmapEdges / 2);
  EXPECT_GE(listOf(array, "shortest_ways").points.size(), 2 * milestones);
}

}  // namespace
}  // namespace pomdp_crowd_nav
