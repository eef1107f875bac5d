// SPDX-License-Identifier: BSD-3-Clause
#include <dynamic_reconfigure/Reconfigure.h>
#include <dynamic_reconfigure/config_tools.h>
#include <gtest/gtest.h>
#include <nav_msgs/OccupancyGrid.h>

#include <memory>
#include <string>
#include <vector>

#include "../ros/marker_checks.h"
#include "navigation_client.h"

namespace pomdp_crowd_nav {
namespace {

using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

// All messages of a topic of planner_node, for as long as it lives.
template <class Message>
class Listener {
 public:
  explicit Listener(const std::string& topic) {
    subscriber_ = node_.subscribe("planner_node/" + topic, 10, &Listener::onMessage, this);
  }

  bool waitFor(size_t count, double timeout = 10.0) {
    return NavigationClient::waitUntil(timeout, [&] { return messages_.size() >= count; });
  }
  size_t count() const { return messages_.size(); }
  const Message& newest() const { return messages_.back(); }

 private:
  void onMessage(const Message& message) { messages_.push_back(message); }

  ros::NodeHandle node_;
  ros::Subscriber subscriber_;
  std::vector<Message> messages_;
};

void setPlanner(const std::string& name) {
  dynamic_reconfigure::Reconfigure call;
  dynamic_reconfigure::ConfigTools::appendParameter(call.request.config, "planner", name);
  ASSERT_TRUE(ros::service::call("planner_node/set_parameters", call));
}

// Robot at (1, 25) among 400 people, all of whom are seen.
class DisplayTest : public testing::Test {
 protected:
  void SetUp() override { ASSERT_TRUE(client_.connect()); }

  void TearDown() override { endTrip(); }

  void endTrip() {
    client_.cancelAll();
    EXPECT_TRUE(
        client_.waitUntil(10.0, [&] { return client_.status().state == PlannerStatus::IDLE; }));
  }

  // On a new trip only the planner of its own goal decides.
  void decideFor(double x, double y) {
    client_.send(x, y);
    ASSERT_TRUE(client_.waitUntil(30.0, [&] { return client_.feedbackCount() > 0; }))
        << client_.status().stop_cause;
  }

  bool napFor(double duration) {
    return !client_.waitUntil(duration, [] { return false; });
  }

  NavigationClient client_;
};

TEST_F(DisplayTest, PicturesOfFourHundredPeopleKeepTheContract) {
  Listener<MarkerArray> people("belief_markers"), robot("robot_markers"), tree("search_tree");
  decideFor(20.0, 40.0);
  ASSERT_TRUE(tree.waitFor(2));
  ASSERT_TRUE(napFor(3.0));  // tracks become longer
  ASSERT_GT(client_.status().people, 390u);
  for (const auto* pictures : {&people, &robot, &tree}) {
    ASSERT_GT(pictures->count(), 1u);
    expectSound(pictures->newest());
  }
  EXPECT_GT(listOf(people.newest(), "people").points.size(), 390u);
  EXPECT_GT(listOf(people.newest(), "tracks").points.size(), 3000u);
  EXPECT_GT(listOf(people.newest(), "belief").points.size(), 3500u);
  EXPECT_FALSE(listOf(people.newest(), "attended").points.empty());
  EXPECT_FALSE(listOf(tree.newest(), "tree").points.empty());
  EXPECT_FALSE(listOf(tree.newest(), "chosen").points.empty());
  EXPECT_FALSE(listOf(tree.newest(), "rollouts").points.empty());
  const std::string text = listOf(robot.newest(), "status").text;
  EXPECT_NE(text.find(" trials"), std::string::npos) << text;
  EXPECT_EQ(listOf(robot.newest(), "emergency_distance").header.frame_id, "base_link");

  client_.cancelAll();
  ASSERT_TRUE(client_.waitForEnd(10.0));
  EXPECT_TRUE(client_.waitUntil(5.0, [&] {
    return listOf(tree.newest(), "tree").action == Marker::DELETE;
  })) << "the tree of a trip that is over is taken away";
}

// The sequence number of a topic's message counts all that were published, heard or not.
TEST_F(DisplayTest, NothingIsDrawnWhileNobodyLooks) {
  decideFor(20.0, 40.0);
  ASSERT_TRUE(napFor(4.0));  // 16 messages, if they were made
  Listener<CrowdBeliefMessage> beliefs("beliefs");
  ASSERT_TRUE(beliefs.waitFor(1));
  EXPECT_LT(beliefs.newest().header.seq, 12u);
  Listener<MarkerArray> tree("search_tree");
  ASSERT_TRUE(tree.waitFor(1));
}

TEST_F(DisplayTest, ArrivalTimeComesOnceAndAnewWithAnotherGoal) {
  decideFor(20.0, 40.0);
  auto first = std::make_unique<Listener<nav_msgs::OccupancyGrid>>("arrival_time");
  ASSERT_TRUE(first->waitFor(1));
  EXPECT_EQ(first->newest().info.width, 500u);
  ASSERT_TRUE(napFor(2.0));
  EXPECT_EQ(first->count(), 1u);
  Listener<nav_msgs::OccupancyGrid> second("arrival_time");
  ASSERT_TRUE(second.waitFor(1));
  EXPECT_EQ(first->count(), 1u) << "it is latched, not made for everybody";

  decideFor(40.0, 10.0);
  ASSERT_TRUE(second.waitFor(2));
  EXPECT_LE(second.newest().data.at(50 * 500 + 200), 2) << "1 at the newer goal";
  EXPECT_GT(second.newest().data.at(200 * 500 + 100), 10) << "no more at the older";
}

TEST_F(DisplayTest, WhoComesAfterAnotherGoalDoesNotGetTheOldLayer) {
  decideFor(20.0, 40.0);
  {
    Listener<nav_msgs::OccupancyGrid> before("arrival_time");
    ASSERT_TRUE(before.waitFor(1));
  }
  endTrip();
  decideFor(40.0, 10.0);
  Listener<nav_msgs::OccupancyGrid> after("arrival_time");
  ASSERT_TRUE(after.waitFor(1));
  EXPECT_LE(after.newest().data.at(50 * 500 + 200), 2);
  ASSERT_TRUE(napFor(1.0));
  EXPECT_EQ(after.count(), 1u);
}

TEST_F(DisplayTest, TheRoadmapIsShownWhereThereIsOne) {
  Listener<MarkerArray> roadmap("roadmap");
  decideFor(20.0, 40.0);
  ASSERT_TRUE(roadmap.waitFor(1));
  EXPECT_EQ(roadmap.newest().markers.size(), 1u) << "Fast Marching has none: DELETEALL alone";
  endTrip();
  setPlanner("2d_prm");
  decideFor(40.0, 10.0);
  EXPECT_TRUE(client_.waitUntil(10.0, [&] { return roadmap.newest().markers.size() > 3; }));
  expectSound(roadmap.newest());
  EXPECT_FALSE(listOf(roadmap.newest(), "shortest_ways").points.empty());
  endTrip();
  setPlanner("2d_fmm");
}

}  // namespace
}  // namespace pomdp_crowd_nav

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "display_rostest");
  return RUN_ALL_TESTS();
}
