// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <nav_msgs/Odometry.h>
#include <tf2_ros/static_transform_broadcaster.h>

#include <cmath>
#include <optional>

#include "fake_robot.h"
#include "map_publisher.h"

namespace pomdp_crowd_nav {
namespace {

constexpr double kField = 40.0;         // [m]
constexpr double kGoalTolerance = 0.5;  // [m], of the profile
constexpr double kYawTolerance = 0.1;   // [rad], of the launch file

// Where a robot comes to that begins at (10, 10), and whom it waits for.
class ArrivalTest : public testing::Test {
 protected:
  void SetUp() override {
    odometry_ = node_.subscribe("odom", 10, &ArrivalTest::onOdometry, this);
    map_.begin(kField);
    ASSERT_TRUE(client_.connect());
  }

  void TearDown() override {
    client_.cancelAll();
    EXPECT_TRUE(client_.waitForRest(10.0));
  }

  void publishMap() {
    map_.publish();
    const ros::WallTime sent = ros::WallTime::now();
    ASSERT_TRUE(client_.waitUntil(20.0, [&] {
      const double age = client_.status().map_age;
      return age >= 0.0 && age < (ros::WallTime::now() - sent).toSec();
    })) << "the map did not arrive";
  }

  void onOdometry(const nav_msgs::Odometry& odometry) {
    const std::optional<Pose> pose = toPose(odometry.pose.pose);
    if (pose) pose_ = transformed(Pose{Point(10.0, 10.0), 0.5}, *pose);
  }

  FakeRobot robot_;
  MapPublisher map_;
  NavigationClient client_;
  ros::NodeHandle node_;
  ros::Subscriber odometry_;
  Pose pose_;  // of the robot in the map
};

TEST_F(ArrivalTest, GoalOfAnotherFrameIsReachedInPlaceAndHeading) {
  publishMap();
  const Pose hall{Point(9.0, 14.0), -1.2}, goal{Point(3.0, 2.0), -0.8};
  geometry_msgs::TransformStamped transform;
  transform.header.frame_id = "map";
  transform.child_frame_id = "hall";
  transform.transform = toTransform(hall);
  tf2_ros::StaticTransformBroadcaster broadcaster;
  broadcaster.sendTransform(transform);
  client_.waitUntil(1.0, [] { return false; });  // in which the planner hears of it

  client_.send(goal, "hall");
  ASSERT_TRUE(client_.waitForEnd(60.0)) << client_.status().stop_cause;
  EXPECT_EQ(client_.state(), NavigationClient::State::SUCCEEDED) << client_.text();
  client_.waitUntil(0.3, [] { return false; });  // the last odometry
  const Point place(11.95, 11.93);               // of the goal in the map
  EXPECT_LT((pose_.position - place).norm(), kGoalTolerance + 0.06);
  EXPECT_LT(std::abs(wrapAngle(pose_.heading - -2.0)), kYawTolerance + 0.01) << pose_.heading;
}

// The robot begins at the end of a corridor in which somebody stands: it can do nothing but wait,
// while in the open it would drive about, which the model likes better than to rest.
TEST_F(ArrivalTest, PersonInANarrowPassageIsWaitedForByName) {
  map_.add(Point(5.0, 4.0), Point(20.0, 9.0));
  map_.add(Point(5.0, 11.0), Point(20.0, 16.0));
  map_.add(Point(5.0, 9.0), Point(8.5, 11.0));
  publishMap();
  constexpr std::uint64_t kPerson = 42;
  std::atomic<bool> is_there{true};
  robot_.people_spoiler.set([&](TrackedPersons& persons) {
    if (!is_there) return;
    TrackedPerson person;
    person.track_id = kPerson;
    person.pose.pose.position.x = 12.2;
    person.pose.pose.position.y = 10.0;
    persons.tracks = {person};
  });
  client_.send(15.0, 10.0);
  const PlannerStatus& status = client_.status();
  const auto is_named = [&] {
    return status.state == PlannerStatus::WAITING_FOR_PEOPLE && status.blocked_for > 1.5 &&
           status.stop_cause.find("person 42 is in the way since ") == 0;
  };
  EXPECT_TRUE(client_.waitUntil(30.0, is_named)) << status.state_name << ": " << status.stop_cause;
  EXPECT_EQ(status.blocking_person, static_cast<std::int64_t>(kPerson));
  EXPECT_EQ(client_.commandedSpeed(), 0.0);
  EXPECT_LT(pose_.position.x(), 11.0) << "nearer than 1.2 m";

  is_there = false;
  EXPECT_TRUE(client_.waitUntil(20.0, [&] { return status.state == PlannerStatus::DRIVING; }))
      << status.state_name << ": " << status.stop_cause;
  EXPECT_TRUE(client_.waitUntil(20.0, [&] { return pose_.position.x() > 13.0; }));
  EXPECT_EQ(status.blocking_person, -1);
  robot_.people_spoiler.set({});
}

}  // namespace
}  // namespace pomdp_crowd_nav

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "arrival_rostest");
  return RUN_ALL_TESTS();
}
