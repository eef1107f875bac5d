// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <nav_msgs/Odometry.h>
#include <tf2_ros/transform_listener.h>

#include <memory>

#include "fault_probe.h"

namespace pomdp_crowd_nav {
namespace {

// One robot in a namespace of its own, seen from outside.
class Robot {
 public:
  explicit Robot(const std::string& name) : frame_(name + "/map"), client_(name + "/") {
    ros::NodeHandle node(name);
    odometry_ = node.subscribe("odom", 1, &Robot::onOdometry, this);
    pause_ = node.serviceClient<PauseService>("planner_node/pause");
  }

  void send(double x, double y) { client_.send(x, y, frame_); }

  bool pause(bool is_paused) {
    PauseService call;
    call.request.data = is_paused;
    return pause_.call(call);
  }

  NavigationClient& client() { return client_; }
  double speed() const { return speed_; }
  double way() const { return way_; }  // [m]
  const std::string& frame() const { return frame_; }

 private:
  void onOdometry(const nav_msgs::Odometry& odometry) {
    const geometry_msgs::Vector3& velocity = odometry.twist.twist.linear;
    speed_ = std::hypot(velocity.x, velocity.y);
    way_ = std::hypot(odometry.pose.pose.position.x, odometry.pose.pose.position.y);
    EXPECT_EQ(odometry.header.frame_id, frame_.substr(0, frame_.find('/')) + "/odom");
  }

  std::string frame_;
  NavigationClient client_;
  ros::Subscriber odometry_;
  ros::ServiceClient pause_;
  double speed_ = 0.0;
  double way_ = 0.0;
};

bool waitUntil(double timeout, const std::function<bool()>& condition) {
  return NavigationClient::waitUntil(timeout, condition);
}

class TwoRobotsTest : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(one_.client().connect());
    ASSERT_TRUE(two_.client().connect());
  }

  Robot one_{"robot_1"}, two_{"robot_2"};
};

TEST_F(TwoRobotsTest, FramesAreTheirOwn) {
  tf2_ros::Buffer buffer;
  const tf2_ros::TransformListener listener(buffer);
  for (const std::string name : {"robot_1/", "robot_2/"}) {
    EXPECT_TRUE(waitUntil(10.0, [&] {
      return buffer.canTransform(name + "map", name + "base_link", ros::Time(0));
    })) << name;
  }
  EXPECT_FALSE(buffer.canTransform("robot_1/map", "robot_2/base_link", ros::Time(0)));
  EXPECT_FALSE(buffer._frameExists("map"));
  EXPECT_FALSE(buffer._frameExists("base_link"));
}

TEST_F(TwoRobotsTest, EachDrivesToItsGoalAndLeavesTheOtherAlone) {
  one_.send(13.0, 30.0);
  ASSERT_TRUE(waitUntil(60.0, [this] { return one_.speed() > 0.4; }))
      << one_.client().status().stop_cause;
  EXPECT_EQ(two_.speed(), 0.0);
  EXPECT_EQ(two_.client().commandCount(), 0) << "nobody has sent it a goal";
  ASSERT_TRUE(one_.pause(true));
  ASSERT_TRUE(waitUntil(10.0, [this] { return one_.speed() == 0.0; }));

  two_.send(12.0, 20.0);
  ASSERT_TRUE(two_.client().waitForEnd(120.0)) << two_.client().status().stop_cause;
  EXPECT_EQ(two_.client().state(), NavigationClient::State::SUCCEEDED) << two_.client().text();
  EXPECT_EQ(one_.speed(), 0.0) << "it is paused";
  EXPECT_FALSE(one_.client().state().isDone());

  ASSERT_TRUE(one_.pause(false));
  ASSERT_TRUE(one_.client().waitForEnd(120.0)) << one_.client().status().stop_cause;
  EXPECT_EQ(one_.client().state(), NavigationClient::State::SUCCEEDED) << one_.client().text();
  EXPECT_NEAR(one_.way(), 13.0, 1.5);
  EXPECT_NEAR(two_.way(), 12.0, 1.5);
}

// Far apart from what the other test leaves behind, so that nobody arrives meanwhile.
TEST_F(TwoRobotsTest, BothDriveAtOnce) {
  one_.send(60.0, 40.0);
  two_.send(60.0, 60.0);
  ASSERT_TRUE(waitUntil(60.0, [this] { return one_.speed() > 0.4 && two_.speed() > 0.4; }))
      << one_.client().status().stop_cause << ", " << two_.client().status().stop_cause;
  const double one_began = one_.way(), two_began = two_.way();
  expectDriveOn({"two robots in namespaces at once", 0.4}, 3.0, {"robot_1", "robot_2"});
  EXPECT_GT(one_.way(), one_began + 1.0);
  EXPECT_GT(two_.way(), two_began + 1.0);
  EXPECT_FALSE(one_.client().state().isDone()) << one_.client().text();
  EXPECT_FALSE(two_.client().state().isDone()) << two_.client().text();
  one_.client().cancel();
  EXPECT_TRUE(one_.client().waitForEnd(10.0));
  EXPECT_EQ(one_.client().state(), NavigationClient::State::PREEMPTED);
  const double two_went_on = two_.way();
  EXPECT_TRUE(waitUntil(20.0, [&] { return two_.way() > two_went_on + 1.0; }))
      << "the end of one trip is none of the other's: " << two_.client().status().stop_cause;
  two_.client().cancel();
  EXPECT_TRUE(two_.client().waitForEnd(10.0));
}

}  // namespace
}  // namespace pomdp_crowd_nav

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "two_robots_rostest");
  return RUN_ALL_TESTS();
}
