// SPDX-License-Identifier: BSD-3-Clause
#include <geometry_msgs/PoseWithCovarianceStamped.h>
#include <gtest/gtest.h>
#include <nav_msgs/GetPlan.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <future>
#include <limits>

#include "navigation_client.h"
#include "node_process.h"
#include "send_goal_run.h"

namespace pomdp_crowd_nav {
namespace {

class GoalsTest : public testing::Test {
 protected:
  void SetUp() override { ASSERT_TRUE(client_.connect()); }

  void expectRefused(const std::string& reason) {
    ASSERT_TRUE(client_.waitForEnd(5.0));
    EXPECT_EQ(client_.state(), NavigationClient::State::REJECTED);
    EXPECT_NE(client_.text().find(reason), std::string::npos) << client_.text();
  }

  NavigationClient client_;
};

TEST_F(GoalsTest, GoalOffTheMapIsRefused) {
  client_.send(150.0, 50.0);
  expectRefused("off the map");
}

TEST_F(GoalsTest, GoalInsideAnObstacleIsRefused) {
  client_.send(50.0, 70.0);
  expectRefused("inside an obstacle");
}

TEST_F(GoalsTest, GoalThatIsNotFiniteIsRefused) {
  client_.send(std::numeric_limits<double>::quiet_NaN(), 70.0);
  expectRefused("not finite");
}

TEST_F(GoalsTest, GoalInAnUnknownFrameIsRefused) {
  client_.send(10.0, 30.0, "atlantis");
  expectRefused("atlantis");
}

TEST_F(GoalsTest, GoalTooCloseToAnObstacleIsRefused) {
  client_.send(50.0, 64.5);
  expectRefused("too close to an obstacle");
}

TEST_F(GoalsTest, CancelBringsTheBaseToRest) {
  client_.send(20.0, 40.0);
  ASSERT_TRUE(client_.waitForMotion(20.0)) << client_.status().stop_cause;
  client_.cancel();
  ASSERT_TRUE(client_.waitForEnd(5.0));
  EXPECT_EQ(client_.state(), NavigationClient::State::PREEMPTED);
  EXPECT_EQ(client_.text(), "cancelled");
  EXPECT_EQ(client_.commandedSpeed(), 0.0);
  EXPECT_TRUE(
      client_.waitUntil(3.0, [this] { return client_.status().state == PlannerStatus::IDLE; }));
  client_.waitUntil(1.0, [] { return false; });  // in which the guard's last zeros come
  const int commands = client_.commandCount();
  client_.waitUntil(1.0, [] { return false; });
  EXPECT_LE(client_.commandCount(), commands + 2) << "an idle planner must not command the base";
}

TEST_F(GoalsTest, CancelOfAGoalThatIsStillCheckedIsNotLost) {
  const ros::Time soon = ros::Time::now() + ros::Duration(0.15);  // no transform is as new
  client_.send(3.0, 0.0, "odom", soon);
  client_.cancel();
  ASSERT_TRUE(client_.waitForEnd(5.0));
  EXPECT_EQ(client_.state(), NavigationClient::State::RECALLED) << client_.text();
  EXPECT_TRUE(client_.waitForRest(1.0));
}

TEST_F(GoalsTest, NewerGoalPreemptsAndRefusedOneDoesNot) {
  client_.send(20.0, 40.0);
  ASSERT_TRUE(client_.waitForMotion(20.0)) << client_.status().stop_cause;
  {
    NavigationClient other;
    ASSERT_TRUE(other.connect());
    other.send(-20.0, 0.0);
    ASSERT_TRUE(other.waitForEnd(5.0));
    EXPECT_FALSE(client_.state().isDone());
    other.send(15.0, 20.0);
    EXPECT_TRUE(client_.waitForEnd(5.0));
    EXPECT_EQ(client_.state(), NavigationClient::State::PREEMPTED);
    EXPECT_NE(client_.text().find("newer goal"), std::string::npos) << client_.text();
    other.cancel();
    EXPECT_TRUE(other.waitForEnd(5.0));
  }
}

TEST_F(GoalsTest, SendGoalInventsNoMetrics) {
  const ProgramRun run = runSendGoal("--x 1.2 --y 25 --timeout 30");
  EXPECT_EQ(run.status, 1) << run.output;
  EXPECT_NE(run.output.find("no metrics received: remap sim_metrics to /sim_node/metrics"),
            std::string::npos)
      << run.output;
  EXPECT_NE(run.output.find("goal_reached=true travel_time_s=nan min_moving_distance_m=nan"),
            std::string::npos)
      << run.output;
}

TEST_F(GoalsTest, SendGoalSumsUpItsOwnTripWhenANewerGoalTakesOver) {
  auto sender = std::async(std::launch::async, runSendGoal,
                           "--x 20 --y 40 --timeout 60 sim_metrics:=sim_node/metrics "
                           "planner_status:=planner_node/status");
  ASSERT_TRUE(client_.waitForMotion(30.0)) << client_.status().stop_cause;
  ASSERT_TRUE(client_.waitUntil(10.0, [this] { return client_.status().decisions >= 3; }));
  client_.send(15.0, 20.0);
  const ProgramRun run = sender.get();
  EXPECT_EQ(run.status, 0) << run.output;
  unsigned decisions = 0;
  const size_t at = run.output.find("decisions=");
  ASSERT_NE(at, std::string::npos) << run.output;
  EXPECT_EQ(std::sscanf(run.output.c_str() + at, "decisions=%u", &decisions), 1);
  EXPECT_GE(decisions, 3u) << run.output;
  EXPECT_EQ(run.output.find("nan"), std::string::npos) << run.output;
  client_.cancel();
  EXPECT_TRUE(client_.waitForEnd(5.0));
}

TEST_F(GoalsTest, SendGoalSaysInWhatTheTimeRanOut) {
  ros::ServiceClient pause = ros::NodeHandle().serviceClient<PauseService>("planner_node/pause");
  PauseService call;
  call.request.data = true;
  ASSERT_TRUE(pause.call(call));
  const ProgramRun run =
      runSendGoal("--x 20 --y 40 --timeout 3 planner_status:=planner_node/status");
  EXPECT_EQ(run.status, 1) << run.output;
  const size_t said = run.output.find("send_goal: PAUSED: paused\n");
  const size_t ended = run.output.find("send_goal: timed out after 3 s in PAUSED: paused\n");
  EXPECT_LT(said, ended) << run.output;
  EXPECT_NE(ended, std::string::npos) << run.output;
  call.request.data = false;
  ASSERT_TRUE(pause.call(call));
}

// A sender that is ended leaves no robot that drives on.
TEST_F(GoalsTest, SendGoalThatIsEndedCancelsItsGoal) {
  for (const int signal : {SIGINT, SIGTERM}) {
    auto sender = std::async(std::launch::async, runSendGoal, "--x 20 --y 40 --timeout 60");
    ASSERT_TRUE(client_.waitForMotion(30.0)) << client_.status().stop_cause;
    const pid_t process = processOf("send_goal");
    ASSERT_GT(process, 0);
    kill(process, signal);
    const ProgramRun run = sender.get();
    EXPECT_EQ(run.status, 1) << run.output;
    EXPECT_NE(run.output.find("interrupted"), std::string::npos) << run.output;
    EXPECT_NE(run.output.find("PREEMPTED, cancelled"), std::string::npos) << run.output;
    EXPECT_NE(run.output.find("goal_reached=false"), std::string::npos) << run.output;
    EXPECT_TRUE(client_.waitUntil(2.0,
                                  [this] {
                                    return client_.status().state == PlannerStatus::IDLE &&
                                           client_.commandedSpeed() == 0.0;
                                  }))
        << "signal " << signal << ": the robot drives on";
    client_.cancelAll();
  }
}

TEST_F(GoalsTest, PauseStopsAndResumeGoesOn) {
  client_.send(25.0, 45.0);
  ASSERT_TRUE(client_.waitForMotion(20.0)) << client_.status().stop_cause;
  ros::ServiceClient pause = ros::NodeHandle().serviceClient<PauseService>("planner_node/pause");
  PauseService call;
  call.request.data = true;
  ASSERT_TRUE(pause.call(call));
  EXPECT_TRUE(client_.waitForStop(3.0, "paused"));
  call.request.data = false;
  ASSERT_TRUE(pause.call(call));
  EXPECT_TRUE(client_.waitForMotion(10.0));
  client_.cancel();
  EXPECT_TRUE(client_.waitForEnd(5.0));
}

TEST_F(GoalsTest, GoalOfRvizIsDrivenTo) {
  ros::Publisher publisher =
      ros::NodeHandle().advertise<geometry_msgs::PoseStamped>("move_base_simple/goal", 1, true);
  geometry_msgs::PoseStamped goal;
  goal.header.frame_id = "map";
  goal.pose = toMessage(Pose{Point(25.0, 45.0), 0.0});
  publisher.publish(goal);
  EXPECT_TRUE(client_.waitForMotion(20.0)) << client_.status().stop_cause;
  client_.cancelAll();
  EXPECT_TRUE(
      client_.waitUntil(8.0, [this] { return client_.status().state == PlannerStatus::IDLE; }));
}

TEST_F(GoalsTest, RobotIsNotPutOffTheField) {
  const LogListener log;
  ros::Publisher publisher =
      ros::NodeHandle().advertise<geometry_msgs::PoseWithCovarianceStamped>("initialpose", 1);
  geometry_msgs::PoseWithCovarianceStamped pose;
  pose.header.frame_id = "map";
  pose.pose.pose = toMessage(Pose{Point(500.0, 20.0), 0.0});
  const auto isRefused = [&] { return log.has("is off the field and ignored"); };
  for (int i = 0; i < 20 && !client_.waitUntil(0.5, isRefused); ++i) publisher.publish(pose);
  EXPECT_TRUE(isRefused());
}

// How near the way from one side of (50, 50) to the other leads to it; negative without a plan.
double planClearance() {
  ros::ServiceClient service =
      ros::NodeHandle().serviceClient<nav_msgs::GetPlan>("planner_node/make_plan");
  nav_msgs::GetPlan call;
  call.request.start.header.frame_id = call.request.goal.header.frame_id = "map";
  call.request.start.pose = toMessage(Pose{Point(40.0, 50.0), 0.0});
  call.request.goal.pose = toMessage(Pose{Point(60.0, 50.0), 0.0});
  if (!service.call(call) || call.response.plan.poses.size() < 3) return -1.0;
  EXPECT_EQ(call.response.plan.header.frame_id, "map");
  double nearest = std::numeric_limits<double>::infinity();
  for (const auto& pose : call.response.plan.poses) {
    const geometry_msgs::Point& point = pose.pose.position;
    nearest = std::min(nearest, std::hypot(point.x - 50.0, point.y - 50.0));
  }
  return nearest;
}

TEST_F(GoalsTest, MakePlanGoesRoundObstacles) { EXPECT_GT(planClearance(), 7.0); }

TEST_F(GoalsTest, SimulatorCanBeReset) {
  ros::ServiceClient reset = ros::NodeHandle().serviceClient<ResetSimulation>("sim_node/reset");
  ResetSimulation call;
  call.request.world = "no_such_world";
  ASSERT_TRUE(reset.call(call));
  EXPECT_FALSE(call.response.success);
  EXPECT_NE(call.response.message.find("no_such_world"), std::string::npos);
  call.request.world = "scenario_1";  // there is no obstacle at (50, 50)
  call.request.pedestrians = 3;
  call.request.seed = 7;
  ASSERT_TRUE(reset.call(call));
  EXPECT_TRUE(call.response.success) << call.response.message;
  const auto isOpen = [] { return planClearance() >= 0.0 && planClearance() < 1.0; };
  EXPECT_TRUE(NavigationClient::waitUntil(20.0, isOpen)) << "the planner keeps the old map";
  call.request.world = "scenario_2";
  ASSERT_TRUE(reset.call(call));
  EXPECT_TRUE(call.response.success) << call.response.message;
  EXPECT_TRUE(NavigationClient::waitUntil(20.0, [] { return planClearance() > 7.0; }));
}

TEST_F(GoalsTest, ResetToAWorldWithOtherDestinationsIsRefused) {
  ros::ServiceClient reset = ros::NodeHandle().serviceClient<ResetSimulation>("sim_node/reset");
  ResetSimulation call;
  call.request.world = "ucy_zara01";
  call.request.seed = 7;
  ASSERT_TRUE(reset.call(call));
  EXPECT_FALSE(call.response.success);
  EXPECT_NE(call.response.message.find("destinations"), std::string::npos);
}

}  // namespace
}  // namespace pomdp_crowd_nav

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "goals_rostest");
  return RUN_ALL_TESTS();
}
