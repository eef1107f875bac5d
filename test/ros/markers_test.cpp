// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/ros/markers.h"

#include <gtest/gtest.h>

#include <limits>

#include "marker_checks.h"

namespace pomdp_crowd_nav {
namespace {

using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

TEST(TreeMarkers, KeepTheLimitWhateverTheTree) {
  TreeScene scene;
  for (int i = 0; i < 20000; ++i) {
    scene.view.edges.push_back(
        {Point(i, 0.0), Point(i, 1.0), static_cast<float>(i), 0.1F, i % 30 + 1});
    scene.chosen.emplace_back(i, 0.0);
  }
  scene.view.rollouts.push_back({Point(0.0, 0.0), Point(1.0e5, 0.0)});
  expectSound(treeMarkers(scene, 1.0, std_msgs::Header()));
}

TEST(TreeMarkers, GreenIsGoodAndRedIsBad) {
  TreeScene scene;
  scene.view.edges.push_back({Point(0.0, 0.0), Point(1.0, 0.0), -100.0F, 1.0F, 1});
  scene.view.edges.push_back({Point(0.0, 0.0), Point(0.0, 1.0), 500.0F, 1.0F, 1});
  const Marker tree = listOf(treeMarkers(scene, 1.0, std_msgs::Header()), "tree");
  ASSERT_EQ(tree.colors.size(), 4u);
  EXPECT_GT(tree.colors[0].g, tree.colors[0].r) << "the last edge is drawn first";
  EXPECT_GT(tree.colors[2].r, tree.colors[2].g);
}

TEST(TreeMarkers, TheChosenBranchIsBolderThanTheTree) {
  TreeScene scene;
  scene.view.edges.push_back({Point(0.0, 0.0), Point(1.0, 0.0), 0.0F, 1.0F, 1});
  scene.chosen = {Point(0.0, 0.0), Point(1.0, 0.0), Point(2.0, 0.0)};
  const MarkerArray array = treeMarkers(scene, 1.0, std_msgs::Header());
  expectSound(array);
  double highest = 0.0, farthest = 0.0;
  for (const auto& point : listOf(array, "chosen").points) {
    highest = std::max(highest, point.y);
    farthest = std::max(farthest, point.x);
  }
  EXPECT_GT(2.0 * highest, 2.0 * listOf(array, "tree").scale.x);
  EXPECT_NEAR(farthest, 2.3, 1e-6);
}

TEST(TreeMarkers, AreEmptyForAnEmptyTree) {
  expectSound(treeMarkers(TreeScene(), 1.0, std_msgs::Header()));
}

TEST(TreeMarkers, LeaveOutWhatIsNotFinite) {
  TreeScene scene;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  scene.view.edges.push_back({Point(nan, 0.0), Point(1.0, 0.0), 0.0F, 1.0F, 1});
  scene.view.rollouts.push_back({Point(0.0, 0.0), Point(nan, 0.0), Point(1.0, 0.0)});
  scene.chosen = {Point(0.0, 0.0), Point(nan, 0.0), Point(1.0, 0.0)};
  expectSound(treeMarkers(scene, 1.0, std_msgs::Header()));
}

TEST(Rollouts, AreDashedWithGapsAsLongAsTheDashes) {
  TreeScene scene;
  scene.view.rollouts.push_back({Point(0.0, 0.0), Point(7.0, 0.0), Point(24.0, 0.0)});
  const Marker dashes = listOf(treeMarkers(scene, 1.0, std_msgs::Header()), "rollouts");
  double drawn = 0.0;
  for (size_t i = 0; i + 1 < dashes.points.size(); i += 2) {
    drawn += dashes.points[i + 1].x - dashes.points[i].x;
  }
  EXPECT_NEAR(drawn, 12.0, 1e-6);
}

TEST(CrowdMarkers, KeepTheLimitInALargeCrowd) {
  std::vector<Walker> walkers;
  for (int i = 0; i < 20000; ++i) walkers.push_back({i, Point(i, 0.0)});
  expectSound(crowdMarkers(walkers, 0.5, std_msgs::Header()));
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
