// SPDX-License-Identifier: BSD-3-Clause
#include <actionlib_msgs/GoalStatusArray.h>
#include <gtest/gtest.h>

#include <memory>

#include "fake_robot.h"
#include "fault_probe.h"
#include "started_node.h"

namespace pomdp_crowd_nav {
namespace {

// What may end a planner of the profile movo, 1 m/s and 1 m/s^2, and how it ends. How the bounds
// follow is in doc/safety.md.
class PlannerLife : public testing::Test {
 protected:
  PlannerLife() {
    const boost::function<void(const actionlib_msgs::GoalStatusArray&)> count =
        [this](const auto&) { ++goal_statuses_; };
    subscriber_ = node_.subscribe<actionlib_msgs::GoalStatusArray>("move_base/status", 10, count);
    node_.getParam("planner_node/brake_deceleration", deceleration_);
  }

  void startAndDrive() {
    planner_ = std::make_unique<StartedNode>(PLANNER_NODE);
    ASSERT_TRUE(client_.connect());
    client_.send(80.0, 80.0);
    ASSERT_TRUE(waitUntil(40.0, [&] { return robot_.speed() > 0.9; }))
        << client_.status().stop_cause;
  }

  void TearDown() override {
    node_.setParam("planner_node/brake_deceleration", deceleration_);
    EXPECT_TRUE(client_.areCommandsFinite());
  }

  // What is not there when actionlib's clients wait for a server.
  void expectGoalStatuses() {
    goal_statuses_ = 0;
    EXPECT_TRUE(waitUntil(5.0, [this] { return goal_statuses_ >= 5; }));
  }

  static bool waitUntil(double timeout, const std::function<bool()>& condition) {
    return NavigationClient::waitUntil(timeout, condition);
  }

  ros::NodeHandle node_;
  ros::Subscriber subscriber_;
  int goal_statuses_ = 0;
  double deceleration_ = 1.0;  // [m/s^2]
  FakeRobot robot_;
  NavigationClient client_;
  std::unique_ptr<StartedNode> planner_;
};

// Nothing can be added to such a time: what computes the next time of a timer throws.
TEST_F(PlannerLife, ClockOfTheYear2106) {
  startAndDrive();
  robot_.is_clock_at_its_end = true;
  expectRest({"clock of the year 2106", 1.3}, [this] { return robot_.speed() == 0.0; });
  waitUntil(2.5, [] { return false; });  // each timer has come round
  EXPECT_TRUE(planner_->isRunning());
  EXPECT_EQ(robot_.speed(), 0.0);
  expectGoalStatuses();
  robot_.is_clock_at_its_end = false;
  EXPECT_TRUE(client_.waitForMotion(8.0)) << client_.status().stop_cause;
  expectGoalStatuses();
  client_.cancel();
  EXPECT_TRUE(client_.waitForEnd(10.0));
}

// To actionlib one that is stamped so cancels all goals.
TEST_F(PlannerLife, CancelOfTheYear2106) {
  startAndDrive();
  ros::Publisher cancels = node_.advertise<actionlib_msgs::GoalID>("move_base/cancel", 1);
  ASSERT_TRUE(waitUntil(5.0, [&] { return cancels.getNumSubscribers() > 0; }));
  actionlib_msgs::GoalID id;
  id.id = "of nobody";
  id.stamp = FakeRobot::endOfTime();
  cancels.publish(id);
  EXPECT_TRUE(client_.waitForEnd(10.0));
  EXPECT_EQ(client_.state(), NavigationClient::State::PREEMPTED);
  waitUntil(1.0, [] { return false; });
  EXPECT_TRUE(planner_->isRunning());
  expectGoalStatuses();
}

// It takes 3.3 s to brake; a zero before that would stop it hard.
TEST_F(PlannerLife, EndsOnlyWhenASlowBaseIsAtRest) {
  node_.setParam("planner_node/brake_deceleration", 0.3);
  startAndDrive();
  planner_->kill(SIGHUP);
  double last = 0.0;  // [m/s], before it was at rest
  EXPECT_TRUE(waitUntil(10.0, [&] {
    const double speed = robot_.speed();
    if (speed > 0.0) last = speed;
    return speed == 0.0;
  }));
  EXPECT_LT(last, 0.2);
  int status = -1;
  EXPECT_TRUE(waitUntil(5.0, [&] {
    status = planner_->exitStatus();
    return status >= 0;
  }));
  EXPECT_EQ(status, 0);
}

}  // namespace
}  // namespace pomdp_crowd_nav

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "planner_life_rostest");
  return RUN_ALL_TESTS();
}
