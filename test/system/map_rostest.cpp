// SPDX-License-Identifier: BSD-3-Clause
#include <actionlib/client/action_client.h>
#include <gtest/gtest.h>
#include <nav_msgs/Odometry.h>

#include <vector>

#include "fake_robot.h"
#include "fault_probe.h"
#include "map_publisher.h"

namespace pomdp_crowd_nav {
namespace {

constexpr double kTopSpeed = 1.0;      // [m/s], of the profile
constexpr double kSmallField = 40.0;   // [m]
constexpr double kLargeField = 200.0;  // [m], 2000 x 2000 cells

// A robot that has begun to drive along y = 10 on a field of its own map.
class MapTest : public testing::Test {
 protected:
  void SetUp() override {
    odometry_ = node_.subscribe("odom", 10, &MapTest::onOdometry, this);
    ASSERT_TRUE(client_.connect());
  }

  void TearDown() override {
    client_.cancelAll();
    EXPECT_TRUE(client_.waitForRest(10.0));
    EXPECT_TRUE(client_.areCommandsFinite());
    EXPECT_LE(client_.topSpeed(), kTopSpeed + 1e-6);
  }

  void driveOn(double side) {
    map_.begin(side);
    map_.publish();
    const ros::WallTime sent = ros::WallTime::now();
    ASSERT_TRUE(client_.waitUntil(20.0, [&] {
      const double age = client_.status().map_age;
      return age >= 0.0 && age < (ros::WallTime::now() - sent).toSec();
    })) << "the map did not arrive";
    client_.send(35.0, 10.0);
    ASSERT_TRUE(client_.waitForMotion(90.0, 0.95 * kTopSpeed)) << client_.status().stop_cause;
  }

  void onOdometry(const nav_msgs::Odometry& odometry) {
    const std::optional<Pose> pose = toPose(odometry.pose.pose);
    if (pose) place_ = transformed(Pose{Point(10.0, 10.0), 0.5}, *pose).position;
  }

  bool isAtRest() const { return client_.commandedSpeed() == 0.0; }

  FakeRobot robot_;
  MapPublisher map_;
  NavigationClient client_;
  ros::NodeHandle node_;
  ros::Subscriber odometry_;
  Point place_{10.0, 10.0};  // [m], of the robot
};

TEST_F(MapTest, RepublishedMapDoesNotStopTheRobot) {
  driveOn(kLargeField);
  int boxes = 0;
  const auto republish = [&] {
    for (int i = 0; i < 8; ++i, ++boxes) {
      map_.add(Point(20.0 + boxes, 30.0), Point(20.5 + boxes, 31.0));
      map_.publish();
      client_.waitUntil(1.0, [] { return false; });
    }
  };
  const auto reading = expectDriveOn({"map republished with changes", 0.4}, republish);
  expectNoHardStop(reading);
}

TEST_F(MapTest, SameMapAgainChangesNothing) {
  driveOn(kSmallField);
  const CommandMeter commands;
  for (int i = 0; i < 10; ++i) {
    map_.publish();
    client_.waitUntil(0.2, [] { return false; });
  }
  expectNoHardStop(commands.reading());
}

// Walls all round the robot, so that there is nothing to do but to rest before them.
TEST_F(MapTest, ObstacleRightAheadInANewMapIsStoppedFor) {
  driveOn(kSmallField);
  constexpr double kAhead = 2.0, kThick = 0.3;  // [m]
  const Point near = place_ - Point(3.0, 3.0), far = place_ + Point(kAhead, 3.0);
  map_.add(Point(far.x(), near.y()), Point(far.x() + kThick, far.y()));
  map_.add(Point(near.x(), near.y()), Point(near.x() + kThick, far.y()));
  map_.add(near, Point(far.x(), near.y() + kThick));
  map_.add(Point(near.x(), far.y()), Point(far.x() + kThick, far.y() + kThick));
  map_.publish();
  expectRest({"map republished, obstacle right ahead", 2.5}, [this] { return isAtRest(); });
  EXPECT_GE(far.x() - place_.x(), 0.5) << "it came nearer than its radius";
  ASSERT_TRUE(client_.waitForEnd(20.0));
  EXPECT_NE(client_.text().find("no way to the goal"), std::string::npos) << client_.text();
}

TEST_F(MapTest, GoalInsideAnObstacleOfANewMapFails) {
  driveOn(kSmallField);
  map_.add(Point(33.0, 8.0), Point(37.0, 12.0));
  map_.publish();
  expectRest({"map republished, goal in an obstacle", 1.5}, [this] { return isAtRest(); });
  ASSERT_TRUE(client_.waitForEnd(5.0));
  EXPECT_EQ(client_.state(), NavigationClient::State::ABORTED);
  EXPECT_NE(client_.text().find("failed: goal (35.00, 10.00) is inside an obstacle"),
            std::string::npos)
      << client_.text();
}

TEST_F(MapTest, GoalToWhichANewMapLeavesNoWayFails) {
  driveOn(kSmallField);
  map_.add(Point(28.0, 0.0), Point(28.5, kSmallField));
  map_.publish();
  expectRest({"map republished, no way to the goal", 2.5}, [this] { return isAtRest(); });
  ASSERT_TRUE(client_.waitForEnd(5.0));
  EXPECT_EQ(client_.state(), NavigationClient::State::ABORTED);
  EXPECT_NE(client_.text().find("no way to the goal"), std::string::npos) << client_.text();
  EXPECT_LT(place_.x(), 27.5);
}

TEST_F(MapTest, CancelAtFullSpeed) {
  driveOn(kSmallField);
  client_.cancel();
  expectRest({"cancel at full speed", 1.5}, [this] { return isAtRest(); });
  ASSERT_TRUE(client_.waitForEnd(5.0));
  EXPECT_EQ(client_.state(), NavigationClient::State::PREEMPTED);
  EXPECT_EQ(client_.text(), "cancelled");
}

TEST_F(MapTest, GoalPreemptedFiftyTimes) {
  using ActionClient = actionlib::ActionClient<move_base_msgs::MoveBaseAction>;
  driveOn(kSmallField);
  ActionClient action("move_base");
  ASSERT_TRUE(client_.waitUntil(10.0, [&] { return action.isServerConnected(); }));
  std::vector<ActionClient::GoalHandle> handles;
  const auto send = [&] {
    for (int i = 0; i < 51; ++i) {
      move_base_msgs::MoveBaseGoal goal;
      goal.target_pose.header.frame_id = "map";
      goal.target_pose.pose = toMessage(Pose{Point(35.0, 10.0 + 0.1 * i), 0.0});
      handles.push_back(action.sendGoal(goal));
      client_.waitUntil(0.1, [] { return false; });
    }
  };
  const auto reading = expectDriveOn({"goal preempted 50 times at 10 Hz", 0.4}, send);
  expectNoHardStop(reading);
  const auto is_over = [](ActionClient::GoalHandle& handle) {
    return handle.getCommState() == actionlib::CommState::DONE;
  };
  for (size_t i = 0; i + 1 < handles.size(); ++i) {
    ASSERT_TRUE(client_.waitUntil(2.0, [&] { return is_over(handles[i]); })) << i;
    EXPECT_EQ(handles[i].getTerminalState().state_, actionlib::TerminalState::PREEMPTED) << i;
    EXPECT_EQ(handles[i].getTerminalState().getText(), "preempted by a newer goal") << i;
  }
  ASSERT_TRUE(client_.waitUntil(60.0, [&] { return is_over(handles.back()); }));
  EXPECT_EQ(handles.back().getTerminalState().state_, actionlib::TerminalState::SUCCEEDED);
  EXPECT_LT((place_ - Point(35.0, 15.0)).norm(), 0.6);
}

}  // namespace
}  // namespace pomdp_crowd_nav

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "map_rostest");
  return RUN_ALL_TESTS();
}
