// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <optional>

#include "navigation_client.h"

namespace pomdp_crowd_nav {
namespace {

class TripTest : public testing::Test {
 protected:
  TripTest() {
    metrics_subscriber_ = node_.subscribe("sim_node/metrics", 10, &TripTest::onMetrics, this);
    beliefs_subscriber_ = node_.subscribe("planner_node/beliefs", 10, &TripTest::onBeliefs, this);
  }

  void onMetrics(const EpisodeMetricsMessage& metrics) { metrics_ = metrics; }
  void onBeliefs(const CrowdBeliefMessage& beliefs) { beliefs_ = beliefs; }

  ros::NodeHandle node_;
  ros::Subscriber metrics_subscriber_, beliefs_subscriber_;
  std::optional<EpisodeMetricsMessage> metrics_;
  std::optional<CrowdBeliefMessage> beliefs_;
  NavigationClient client_;
};

TEST_F(TripTest, PlannerAndSimulatorDriveToTheGoal) {
  ASSERT_TRUE(client_.connect());
  client_.send(13.0, 30.0);
  ASSERT_TRUE(client_.waitForEnd(60.0)) << client_.status().stop_cause;
  EXPECT_EQ(client_.state(), NavigationClient::State::SUCCEEDED) << client_.text();
  EXPECT_EQ(client_.text(), "goal reached");

  EXPECT_TRUE(client_.areCommandsFinite());
  EXPECT_GT(client_.topSpeed(), 0.5);
  EXPECT_LE(client_.topSpeed(), 2.0 + 1e-6);
  EXPECT_EQ(client_.commandedSpeed(), 0.0);
  EXPECT_GT(client_.feedbackCount(), 2);
  EXPECT_GT(client_.status().decisions, 2u);
  EXPECT_GT(client_.mostTrials(), 0u);

  ASSERT_TRUE(metrics_);
  EXPECT_TRUE(client_.waitUntil(2.0, [this] { return metrics_->goal_reached; }));
  EXPECT_TRUE(client_.waitUntil(2.0, [this] { return metrics_->at_rest; }));
  EXPECT_GT(metrics_->path_length, 11.0);
  EXPECT_EQ(metrics_->contact_ticks, 0u);
  EXPECT_EQ(metrics_->decisions, client_.status().decisions);

  ASSERT_TRUE(beliefs_);
  EXPECT_EQ(beliefs_->destinations.size(), 4u);
  ASSERT_FALSE(beliefs_->people.empty());
  EXPECT_EQ(beliefs_->people.front().probabilities.size(), 4u);
}

}  // namespace
}  // namespace pomdp_crowd_nav

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "trip_rostest");
  return RUN_ALL_TESTS();
}
