// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/ros/markers.h"

#include <gtest/gtest.h>

#include <limits>

namespace pomdp_crowd_nav {
namespace {

using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

void expectSound(const MarkerArray& array) {
  ASSERT_FALSE(array.markers.empty());
  EXPECT_EQ(array.markers.front().action, Marker::DELETEALL);
  EXPECT_LE(array.markers.size(), 5u);
  for (size_t i = 1; i < array.markers.size(); ++i) {
    const Marker& marker = array.markers[i];
    EXPECT_LT(marker.points.size(), kMaxPoints);
    EXPECT_EQ(marker.action, marker.points.empty() ? Marker::DELETE : Marker::ADD)
        << "RViz takes no empty list for " << marker.ns;
    EXPECT_EQ(marker.points.size(), marker.colors.size());
    EXPECT_GT(marker.scale.x, 0.0);
    EXPECT_DOUBLE_EQ(marker.pose.orientation.w, 1.0);
    const size_t corners = marker.type == Marker::LINE_LIST       ? 2
                           : marker.type == Marker::TRIANGLE_LIST ? 3
                                                                  : 1;
    EXPECT_EQ(marker.points.size() % corners, 0u);
    for (const auto& point : marker.points) {
      EXPECT_TRUE(std::isfinite(point.x) && std::isfinite(point.y));
    }
  }
}

TEST(TreeMarkers, KeepTheLimitWhateverTheTree) {
  TreeView view;
  for (int i = 0; i < 20000; ++i) {
    view.edges.push_back({Point(i, 0.0), Point(i, 1.0), static_cast<float>(i), 0.1F, i % 30 + 1});
  }
  view.rollouts.push_back({Point(0.0, 0.0), Point(1.0e5, 0.0)});
  expectSound(treeMarkers(view, 1.0, std_msgs::Header()));
}

TEST(TreeMarkers, GreenIsGoodAndRedIsBad) {
  TreeView view;
  view.edges.push_back({Point(0.0, 0.0), Point(1.0, 0.0), -100.0F, 1.0F, 1});
  view.edges.push_back({Point(0.0, 0.0), Point(0.0, 1.0), 500.0F, 1.0F, 1});
  const Marker tree = treeMarkers(view, 1.0, std_msgs::Header()).markers[1];
  ASSERT_EQ(tree.colors.size(), 4u);
  EXPECT_GT(tree.colors[0].r, tree.colors[0].g);
  EXPECT_GT(tree.colors[2].g, tree.colors[2].r);
}

TEST(TreeMarkers, AreEmptyForAnEmptyTree) {
  expectSound(treeMarkers(TreeView(), 1.0, std_msgs::Header()));
  expectSound(beliefMarkers({CrowdBelief(), {Point(0.0, 0.0)}, {}, 1.0}, std_msgs::Header()));
}

TEST(TreeMarkers, LeaveOutWhatIsNotFinite) {
  TreeView view;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  view.edges.push_back({Point(nan, 0.0), Point(1.0, 0.0), 0.0F, 1.0F, 1});
  view.rollouts.push_back({Point(0.0, 0.0), Point(nan, 0.0), Point(1.0, 0.0)});
  expectSound(treeMarkers(view, 1.0, std_msgs::Header()));
}

TEST(Rollouts, AreDashedWithGapsAsLongAsTheDashes) {
  TreeView view;
  view.rollouts.push_back({Point(0.0, 0.0), Point(7.0, 0.0), Point(24.0, 0.0)});
  const Marker dashes = treeMarkers(view, 1.0, std_msgs::Header()).markers[2];
  double drawn = 0.0;
  for (size_t i = 0; i + 1 < dashes.points.size(); i += 2) {
    drawn += dashes.points[i + 1].x - dashes.points[i].x;
  }
  EXPECT_NEAR(drawn, 12.0, 1e-6);
}

TEST(BeliefMarkers, ShowTheLikeliestDestinationMoreOpaqueTheSurer) {
  const std::vector<Point> destinations = {Point(0.0, 0.0), Point(10.0, 0.0)};
  PersonBelief sure{1, Point(5.0, 5.0), Point(0.0, 0.0), 1.0, IntentionBelief(2)};
  PersonBelief unsure = sure;
  for (int i = 0; i < 20; ++i) {
    sure.intention.update(Point(5.0, 0.0), Point(6.0, 0.0), destinations);
  }
  CrowdBelief crowd{0.0, {sure, unsure}};
  const MarkerArray array = beliefMarkers({crowd, destinations, {1}, 1.0}, std_msgs::Header());
  expectSound(array);
  const Marker& discs = array.markers[1];
  ASSERT_EQ(discs.points.size(), 2u);
  EXPECT_GT(discs.colors[0].a, discs.colors[1].a);
  EXPECT_EQ(discs.colors[0].r, destinationColor(1, 1.0).r);
  EXPECT_FALSE(array.markers[3].points.empty()) << "the attended person has a ring";
}

TEST(BeliefMarkers, TellWhoStandsAndWhoWalksElsewhere) {
  const std::vector<Point> destinations = {Point(0.0, 0.0), Point(10.0, 0.0)};
  PersonBelief stands{1, Point(5.0, 5.0), Point(0.0, 0.0), 1.0, IntentionBelief(2, 0.8, 0.1)};
  PersonBelief leaves{
      2, Point(5.0, 5.0), Point(0.0, 0.0), 1.0, IntentionBelief(2, 0.1, 0.8), Point(0.0, 1.0)};
  const CrowdBelief crowd{0.0, {stands, leaves}};
  const MarkerArray array = beliefMarkers({crowd, destinations, {}, 1.0}, std_msgs::Header());
  expectSound(array);
  const Marker& discs = array.markers[1];
  ASSERT_EQ(discs.points.size(), 2u);
  EXPECT_EQ(discs.colors[0].r, 0.0F);
  EXPECT_GT(discs.colors[1].r, 0.0F);
  EXPECT_EQ(discs.colors[1].r, discs.colors[1].g);
  const Marker& ways = array.markers[2];
  ASSERT_EQ(ways.points.size(), 2u) << "who stands has no way";
  EXPECT_DOUBLE_EQ(ways.points[1].x, 5.0);
  EXPECT_GT(ways.points[1].y, 5.0);
}

TEST(CrowdMarkers, KeepTheLimitInALargeCrowd) {
  std::vector<Walker> walkers;
  for (int i = 0; i < 20000; ++i) walkers.push_back({i, Point(i, 0.0)});
  const std::vector<Point> trail(20000, Point(1.0, 1.0));
  expectSound(crowdMarkers({walkers, trail, Pose{}, 0.5, 0.5}, std_msgs::Header()));
}

TEST(WorldMarkers, ShowEveryShippedKindOfObstacle) {
  World world;
  world.destinations = {Point(0.0, 0.0)};
  world.obstacles.circles.push_back({Point(5.0, 5.0), 2.0});
  world.obstacles.polygons.push_back({{Point(1.0, 1.0), Point(2.0, 1.0)}, false});
  expectSound(worldMarkers(world, 1.0, std_msgs::Header()));
}

}  // namespace
}  // namespace pomdp_crowd_nav
