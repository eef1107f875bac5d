// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cstdio>

#include "fake_robot.h"
#include "pomdp_crowd_nav/ros/map_conversions.h"

namespace pomdp_crowd_nav {
namespace {

nav_msgs::OccupancyGrid smallGrid() {
  nav_msgs::OccupancyGrid grid;
  grid.header.frame_id = "map";
  grid.info.resolution = 1.0;
  grid.info.width = grid.info.height = 4;
  grid.info.origin.orientation.w = 1.0;
  grid.data.assign(16, 0);
  return grid;
}

// The tool listens to a robot that is alone in its system: no planner runs.
class CheckInputsTest : public testing::Test {
 protected:
  struct Run {
    std::string output;
    int status = -1;
  };

  CheckInputsTest() : robot_(smallGrid()) {
    NavigationClient::waitUntil(1.0, [] { return false; });  // the robot starts
  }

  static Run run(const std::string& options = "--duration 1.5") {
    Run run;
    FILE* pipe = popen((CHECK_INPUTS " " + options + " 2>&1").c_str(), "r");
    if (!pipe) return run;
    char buffer[256];
    while (fgets(buffer, sizeof(buffer), pipe)) run.output += buffer;
    run.status = WEXITSTATUS(pclose(pipe));
    return run;
  }

  static void expectProblem(const std::string& advice) {
    const Run result = run();
    EXPECT_EQ(result.status, 1) << result.output;
    EXPECT_NE(result.output.find("-> " + advice), std::string::npos) << result.output;
  }

  FakeRobot robot_;
};

TEST_F(CheckInputsTest, AllThere) {
  const Run result = run();
  EXPECT_EQ(result.status, 0) << result.output;
  const std::vector<std::string> words = {"/clock",
                                          "/odom",
                                          "nav_msgs/Odometry",
                                          "spencer_tracking_msgs/TrackedPersons",
                                          "not needed, people come on /tracked_persons",
                                          "heard by " + ros::this_node::getName()};
  for (const std::string& word : words) {
    EXPECT_NE(result.output.find(word), std::string::npos) << word << "\n" << result.output;
  }
  EXPECT_EQ(result.output.find("->"), std::string::npos) << result.output;
}

TEST_F(CheckInputsTest, SilentOdometry) {
  robot_.is_odometry_silent = true;
  expectProblem("/odom is published by");
}

TEST_F(CheckInputsTest, OdometryOnAnotherTopic) {
  const Run result = run("--duration 1 odom:=/wheels");
  EXPECT_EQ(result.status, 1);
  EXPECT_NE(result.output.find("nobody publishes /wheels"), std::string::npos) << result.output;
}

TEST_F(CheckInputsTest, OdometryNotFinite) {
  robot_.is_odometry_nan = true;
  expectProblem("/odom: a number is not finite");
}

TEST_F(CheckInputsTest, OdometryInAnUnknownFrame) {
  robot_.odometry_spoiler.set([](nav_msgs::Odometry& o) { o.header.frame_id = "wheels"; });
  expectProblem("no transform leads from 'wheels' to 'map'");
}

TEST_F(CheckInputsTest, OldOdometry) {
  robot_.odometry_spoiler.set([](nav_msgs::Odometry& o) { o.header.stamp -= ros::Duration(0.8); });
  const Run result = run();
  EXPECT_EQ(result.status, 1) << result.output;
  EXPECT_NE(result.output.find("s old when it comes"), std::string::npos) << result.output;
}

TEST_F(CheckInputsTest, MissingTransform) {
  robot_.is_transform_silent = true;
  expectProblem("no transform leads from 'odom' to 'map'");
}

TEST_F(CheckInputsTest, SilentPeople) {
  robot_.are_people_silent = true;
  expectProblem("/tracked_persons is published by");
}

TEST_F(CheckInputsTest, AnotherTypeOnATopicOfPeople) {
  robot_.are_people_silent = true;
  ros::Publisher wrong = ros::NodeHandle().advertise<geometry_msgs::Twist>("people", 1, true);
  wrong.publish(geometry_msgs::Twist());
  expectProblem("/people carries geometry_msgs/Twist");
}

TEST_F(CheckInputsTest, PeopleOfPeopleMsgsAreEnough) {
  robot_.are_people_silent = true;
  ros::Publisher publisher = ros::NodeHandle().advertise<Foreign<People>>("people", 1);
  std::atomic<bool> stop{false};
  std::thread thread([&] {
    while (!stop) {
      People people;
      people.header.frame_id = "map";
      people.header.stamp = ros::Time::now();
      publisher.publish(Foreign<People>{people});
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
    }
  });
  const Run result = run();
  stop = true;
  thread.join();
  EXPECT_NE(result.output.find("not needed, people come on /people"), std::string::npos)
      << result.output;
  EXPECT_EQ(result.status, 0) << result.output;
}

TEST_F(CheckInputsTest, NoCommandsAreHeard) {
  const Run result = run("--duration 1 cmd_vel:=/nowhere");
  EXPECT_EQ(result.status, 1);
  EXPECT_NE(result.output.find("nobody listens to /nowhere"), std::string::npos) << result.output;
}

TEST_F(CheckInputsTest, ClockThatStandsStill) {
  robot_.is_clock_frozen = true;
  expectProblem("/clock stands still");
}

TEST_F(CheckInputsTest, AParameterOfThePlannerNamesTheFrame) {
  ros::param::set("/some_planner/global_frame", "world");
  const Run result = run("--duration 1 --node some_planner");
  ros::param::del("/some_planner");
  EXPECT_EQ(result.status, 1);
  EXPECT_NE(result.output.find("to 'world'"), std::string::npos) << result.output;
}

TEST_F(CheckInputsTest, BadArguments) {
  EXPECT_EQ(run("--duration never").status, 2);
  EXPECT_EQ(run("--durations 1").status, 2);
}

TEST(CheckInputs, AMissingMapIsNamedUnlessAWorldFileGivesOne) {
  FakeRobot robot;  // without a map
  NavigationClient::waitUntil(1.0, [] { return false; });
  const auto run = [](const std::string& options) {
    return WEXITSTATUS(std::system((CHECK_INPUTS " --duration 1.5" + options).c_str()));
  };
  EXPECT_EQ(run(""), 1);
  ros::param::set("/planner_node/world_file", "some.yaml");
  EXPECT_EQ(run(""), 0);
  ros::param::del("/planner_node");
}

}  // namespace
}  // namespace pomdp_crowd_nav

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "check_inputs_rostest");
  return RUN_ALL_TESTS();
}
