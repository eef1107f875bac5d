// SPDX-License-Identifier: BSD-3-Clause
#include <dynamic_reconfigure/Reconfigure.h>
#include <dynamic_reconfigure/config_tools.h>
#include <gtest/gtest.h>
#include <ros/master.h>
#include <ros/network.h>
#include <xmlrpcpp/XmlRpcClient.h>

#include <limits>

#include "navigation_client.h"

namespace pomdp_crowd_nav {
namespace {

using dynamic_reconfigure::Config;
using dynamic_reconfigure::ConfigTools;

// What the server answers: the values that hold now.
class Answer {
 public:
  explicit Answer(const Config& config) : config_(config) {}

  double number(const std::string& name) const { return get<double>(name); }
  int integer(const std::string& name) const { return get<int>(name); }
  std::string text(const std::string& name) const { return get<std::string>(name); }

 private:
  template <typename T>
  T get(const std::string& name) const {
    T value{};
    EXPECT_TRUE(ConfigTools::getParameter(config_, name, value)) << name;
    return value;
  }

  Config config_;
};

class ReconfigureTest : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(client_.connect());
    ASSERT_TRUE(client_.waitUntil(10.0, [&] { return log_.programs() >= 3; }));
  }

  void TearDown() override {
    client_.cancelAll();
    EXPECT_TRUE(waitForState(PlannerStatus::IDLE));
    Config config;
    ConfigTools::appendParameter(config, "planner", std::string("2d_fmm"));
    ConfigTools::appendParameter(config, "reward_goal", 1000.0);
    ConfigTools::appendParameter(config, "search_scenarios", 100);
    ConfigTools::appendParameter(config, "model_obstacle_distance", 2.0);
    ConfigTools::appendParameter(config, "search_time", 0.5);
    request(config);
  }

  Answer request(const Config& config) {
    dynamic_reconfigure::Reconfigure call;
    call.request.config = config;
    EXPECT_TRUE(ros::service::call("planner_node/set_parameters", call));
    return Answer(call.response.config);
  }

  template <typename T>
  Answer set(const std::string& name, const T& value) {
    Config config;
    ConfigTools::appendParameter(config, name, value);
    return request(config);
  }

  template <typename T>
  static T onServer(const std::string& key) {
    T value{};
    EXPECT_TRUE(ros::param::get("/planner_node/" + key, value)) << key;
    return value;
  }

  bool waitForState(std::uint8_t state) {
    return client_.waitUntil(10.0, [&] { return client_.status().state == state; });
  }

  bool waitForLog(const std::string& text) {
    return client_.waitUntil(10.0, [&] { return log_.has(text); });
  }

  void driveTo(double x, double y) {
    client_.send(x, y);
    ASSERT_TRUE(client_.waitForMotion(20.0)) << client_.status().stop_cause;
  }

  NavigationClient client_;
  LogListener log_;
};

TEST_F(ReconfigureTest, WeightsAndSearchChangeInFlightWithoutAGapInTheCommands) {
  driveTo(20.0, 40.0);
  ASSERT_TRUE(client_.waitUntil(10.0, [&] { return client_.status().upper_bound > 100.0; }));
  const int commands = client_.commandCount();
  const ros::WallTime begin = ros::WallTime::now();
  EXPECT_EQ(set("reward_goal", 50.0).number("reward_goal"), 50.0);
  EXPECT_EQ(set("search_scenarios", 40).integer("search_scenarios"), 40);
  EXPECT_EQ(set("search_time", 0.3).number("search_time"), 0.3);
  EXPECT_EQ(onServer<double>("reward/goal"), 50.0);
  EXPECT_EQ(onServer<int>("search/scenarios"), 40);
  EXPECT_FALSE(ros::param::has("/planner_node/reward_goal")) << "one name on the server";
  EXPECT_TRUE(client_.waitUntil(10.0, [&] { return client_.status().upper_bound <= 50.0; }))
      << "decisions still aim for " << client_.status().upper_bound;
  EXPECT_TRUE(client_.waitUntil(5.0, [&] { return client_.status().cycle_time < 0.4; }));
  const double duration = (ros::WallTime::now() - begin).toSec();
  EXPECT_GT(client_.commandCount() - commands, 0.8 * 20.0 * duration) << "20 Hz";
  EXPECT_FALSE(client_.state().isDone()) << client_.text();
  EXPECT_TRUE(waitForLog("parameters changed: reward/goal 1000"));
}

TEST_F(ReconfigureTest, AnotherClearanceIsTakenOnTheWay) {
  driveTo(8.0, 45.0);
  EXPECT_EQ(set("model_obstacle_distance", 1.0).number("model_obstacle_distance"), 1.0);
  EXPECT_TRUE(waitForLog("planner 2d_fmm goes on with the new parameters"));
  EXPECT_TRUE(client_.waitForEnd(60.0)) << client_.status().stop_cause;
  EXPECT_EQ(client_.state(), NavigationClient::State::SUCCEEDED) << client_.text();
}

TEST_F(ReconfigureTest, AnotherPlannerIsRefusedOnATripAndDrivesTheNextOne) {
  driveTo(25.0, 45.0);
  EXPECT_EQ(set("planner", std::string("2d_straight")).text("planner"), "2d_fmm");
  EXPECT_EQ(onServer<std::string>("planner"), "2d_fmm");
  EXPECT_TRUE(waitForLog("planner can be changed only while no trip is under way"));
  client_.cancel();
  ASSERT_TRUE(client_.waitForEnd(5.0));
  ASSERT_TRUE(waitForState(PlannerStatus::IDLE));
  EXPECT_EQ(set("planner", std::string("2d_straight")).text("planner"), "2d_straight");
  client_.send(15.0, 45.0);
  EXPECT_TRUE(waitForLog("planner 2d_straight is ready"));
  EXPECT_TRUE(client_.waitForMotion(20.0)) << client_.status().stop_cause;
}

TEST_F(ReconfigureTest, ValuesOutOfRangeAreClampedOrRefused) {
  EXPECT_EQ(set("search_scenarios", 1000000).integer("search_scenarios"), 5000);
  EXPECT_EQ(set("reward_time", 3.0).number("reward_time"), 0.0);
  EXPECT_EQ(set("reward_time", -1.0).number("reward_time"), -1.0);
  const double no_number = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(set("reward_goal", no_number).number("reward_goal"), 1000.0);
  EXPECT_TRUE(waitForLog("parameters stay as they were: reward/goal must be"));
  EXPECT_EQ(set("planner", std::string("3d_magic")).text("planner"), "2d_fmm");
  EXPECT_TRUE(waitForLog("got '3d_magic'"));
}

TEST_F(ReconfigureTest, ValuesThatDoNotGoTogetherAreAllPutBack) {
  Config config;
  ConfigTools::appendParameter(config, "reward_goal", 700.0);
  ConfigTools::appendParameter(config, "model_far_distance", 2.0);
  const Answer answer = request(config);
  EXPECT_EQ(answer.number("model_far_distance"), 6.0);
  EXPECT_EQ(answer.number("reward_goal"), 1000.0);
  EXPECT_EQ(onServer<double>("model/far_distance"), 6.0);
  EXPECT_EQ(onServer<double>("reward/goal"), 1000.0);
  EXPECT_TRUE(waitForLog("far_distance must be at least near_distance, got 2"));
}

// Ends the node as `rosnode kill` does.
std::string uriOfPlanner() {
  XmlRpc::XmlRpcValue args, result, payload;
  args[0] = ros::this_node::getName();
  args[1] = "/planner_node";
  const bool known = ros::master::execute("lookupNode", args, result, payload, false);
  return known ? static_cast<std::string>(payload) : "";
}

void endPlanner() {
  std::string host;
  std::uint32_t port = 0;
  ASSERT_TRUE(ros::network::splitURI(uriOfPlanner(), host, port));
  XmlRpc::XmlRpcClient node(host.c_str(), static_cast<int>(port), "/");
  XmlRpc::XmlRpcValue args, result;
  args[0] = ros::this_node::getName();
  args[1] = "a test of what comes after";
  node.execute("shutdown", args, result);
}

TEST_F(ReconfigureTest, ANodeThatIsStartedAgainFindsTheNewestValues) {
  set("reward_goal", 800.0);
  set("planner", std::string("2d_straight"));
  const std::string before = uriOfPlanner();
  endPlanner();
  ASSERT_TRUE(client_.waitUntil(30.0, [&] {
    return uriOfPlanner() != before && ros::service::exists("planner_node/set_parameters", false);
  })) << "the node does not come back";
  const Answer answer = request(Config());
  EXPECT_EQ(answer.number("reward_goal"), 800.0);
  EXPECT_EQ(answer.text("planner"), "2d_straight");
  ASSERT_TRUE(client_.connect());
  client_.waitUntil(2.0, [] { return false; });  // until it has seen people for a while
  client_.send(15.0, 45.0);
  EXPECT_TRUE(waitForLog("planner 2d_straight is ready"));
  EXPECT_TRUE(client_.waitForMotion(20.0)) << client_.status().stop_cause;
}

}  // namespace
}  // namespace pomdp_crowd_nav

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "reconfigure_rostest");
  return RUN_ALL_TESTS();
}
