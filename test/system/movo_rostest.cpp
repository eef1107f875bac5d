// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <nav_msgs/OccupancyGrid.h>
#include <ros/advertise_options.h>
#include <ros/master.h>
#include <ros/this_node.h>

#include <chrono>
#include <future>
#include <vector>

#include "fake_robot.h"
#include "send_goal_run.h"

namespace pomdp_crowd_nav {
namespace {

// movo_msgs/Status as its own nodes announce it; layout as in kinova-movo.
constexpr const char* kStatusMd5 = "dde32396dda94858b879d71dd7ee2e6c";
constexpr const char* kConfigCmdMd5 = "48e0d9e9ce5afb7e797ea6a1ab30254b";

nav_msgs::OccupancyGrid hall() {
  nav_msgs::OccupancyGrid grid;
  grid.header.frame_id = "map";
  grid.info.resolution = 0.1f;
  grid.info.width = grid.info.height = 400;
  grid.info.origin.orientation.w = 1.0;
  grid.data.assign(400 * 400, 0);
  return grid;
}

// The base's own nodes: mode and map. The names of their types are those of movo_msgs.
class FakeMovo {
 public:
  FakeMovo() {
    ros::AdvertiseOptions status;
    status.init<MovoStatus>("/movo/feedback/status", 1);
    status.datatype = "movo_msgs/Status";
    status.md5sum = kStatusMd5;
    status_ = node_.advertise(status);
    ros::SubscribeOptions requests;
    requests.init<ConfigCmd>("/movo/gp_command", 10, [this](const ConfigCmd::ConstPtr& request) {
      requests_.push_back(*request);
    });
    requests.datatype = "movo_msgs/ConfigCmd";
    requests.md5sum = kConfigCmdMd5;
    request_subscriber_ = node_.subscribe(requests);
    map_ = node_.advertise<nav_msgs::OccupancyGrid>("/map", 1, true);
    map_.publish(hall());
  }

  void sayMode(std::uint32_t mode) {
    MovoStatus status;
    status.fault_status_words = {1, 2, 3, 4, 5, 6, 7, 8};
    status.operational_time = 12.5f;
    status.operational_state = mode;
    status.machine_id = 7;
    status_.publish(status);
  }

  const std::vector<ConfigCmd>& requests() const { return requests_; }

 private:
  ros::NodeHandle node_;
  ros::Publisher status_, map_;
  ros::Subscriber request_subscriber_;
  std::vector<ConfigCmd> requests_;
};

TEST(Movo, MessagesHaveTheLayoutOfMovoMsgs) {
  EXPECT_STREQ(ros::message_traits::md5sum<ConfigCmd>(), kConfigCmdMd5);
  EXPECT_STREQ(ros::message_traits::md5sum<MovoStatus>(), kStatusMd5);
}

TEST(Movo, TractorModeIsRequestedUntilTheBaseIsInItAndNotAgain) {
  constexpr std::uint32_t kStandby = 3, kTractor = 5;
  FakeMovo movo;
  const FakeRobot clock;
  ASSERT_TRUE(NavigationClient::waitUntil(20.0, [&] {
    movo.sayMode(kStandby);
    return movo.requests().size() >= 3;
  }));
  EXPECT_EQ(movo.requests().back().gp_cmd, "GENERAL_PURPOSE_CMD_SET_OPERATIONAL_MODE");
  EXPECT_EQ(movo.requests().back().gp_param, kTractor);

  for (const std::uint32_t mode : {kTractor, kStandby}) {
    NavigationClient::waitUntil(0.5, [&] {
      movo.sayMode(mode);
      return false;
    });
    const size_t count = movo.requests().size();
    NavigationClient::waitUntil(1.0, [&] {
      movo.sayMode(mode);
      return false;
    });
    EXPECT_EQ(movo.requests().size(), count) << "mode " << mode;
  }
}

// Names of the nodes that subscribe to a topic.
std::string subscribersOf(const std::string& topic) {
  XmlRpc::XmlRpcValue question, answer, state;
  question[0] = ros::this_node::getName();
  if (!ros::master::execute("getSystemState", question, answer, state, false)) return "";
  std::string names;
  for (int i = 0; i < state[1].size(); ++i) {
    if (static_cast<std::string>(state[1][i][0]) != topic) continue;
    for (int j = 0; j < state[1][i][1].size(); ++j) {
      names += static_cast<std::string>(state[1][i][1][j]) + " ";
    }
  }
  return names;
}

TEST(Movo, PlannerAndGuardHearBothTopicsOfPeople) {
  for (const char* topic : {"/tracked_persons", "/leg_tracker/people"}) {
    EXPECT_TRUE(
        NavigationClient::waitUntil(20.0,
                                    [&] {
                                      const std::string names = subscribersOf(topic);
                                      return names.find("/planner_node") != std::string::npos &&
                                             names.find("/velocity_guard") != std::string::npos;
                                    }))
        << topic << ": " << subscribersOf(topic);
  }
}

TEST(Movo, DrivesOnTheTopicsOfTheRobot) {
  const FakeMovo movo;
  const FakeRobot robot;
  NavigationClient client;
  ASSERT_TRUE(client.connect());
  client.send(16.0, 12.0);
  ASSERT_TRUE(client.waitForMotion(30.0)) << client.status().stop_cause;
  ASSERT_TRUE(client.waitForEnd(60.0)) << client.status().stop_cause;
  EXPECT_EQ(client.state(), NavigationClient::State::SUCCEEDED) << client.text();
  EXPECT_TRUE(client.waitForRest(2.0));
  EXPECT_TRUE(client.areCommandsFinite());
  // The limit that the base comes with, which the launch file keeps where nothing else is said.
  EXPECT_GT(client.topSpeed(), 0.4);
  EXPECT_LE(client.topSpeed(), 0.5 + 1e-9);
  EXPECT_EQ(ros::names::resolve("cmd_vel"), "/movo/navigation/cmd_vel");
}

// As doc/movo.md sends it. Nobody on a robot publishes metrics of a simulation.
TEST(Movo, SendGoalEndsWithZeroAtTheGoal) {
  const FakeMovo movo;
  const FakeRobot robot;
  NavigationClient client;
  ASSERT_TRUE(client.connect());
  auto sender = std::async(std::launch::async, runSendGoal,
                           "--x 12 --y 11 --timeout 60 planner_status:=planner_node/status");
  ASSERT_TRUE(client.waitUntil(
      70.0, [&] { return sender.wait_for(std::chrono::seconds(0)) == std::future_status::ready; }));
  const ProgramRun run = sender.get();
  EXPECT_EQ(run.status, 0) << run.output;
  EXPECT_NE(run.output.find("SUCCEEDED, goal reached"), std::string::npos) << run.output;
  EXPECT_NE(run.output.find("goal_reached=true"), std::string::npos) << run.output;
  EXPECT_EQ(run.output.find("metrics"), std::string::npos) << run.output;
}

}  // namespace
}  // namespace pomdp_crowd_nav

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "movo_rostest");
  const ros::NodeHandle node;  // without one ros::ok() does not hold
  return RUN_ALL_TESTS();
}
