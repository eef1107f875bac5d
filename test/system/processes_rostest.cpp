// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <nav_msgs/Odometry.h>

#include <atomic>
#include <thread>

#include "fault_probe.h"
#include "node_process.h"

namespace pomdp_crowd_nav {
namespace {

// Planner, guard and simulator with the profile movo, 1 m/s and 1 m/s^2, on a field with few
// people. Bounds are 0.25 s of the guard's patience or 0.5 s of the base's watchdog, 1.0 s of
// braking, and 0.5 s for a machine that is busy with something else.

class ProcessesTest : public testing::Test {
 protected:
  ProcessesTest() {
    odometry_ = node_.subscribe("odom", 1, &ProcessesTest::onOdometry, this);
    guard_status_ =
        node_.subscribe("velocity_guard/status", 10, &ProcessesTest::onGuardStatus, this);
  }

  void SetUp() override {
    ASSERT_TRUE(client_.connect());
    drive();
  }

  void TearDown() override {
    client_.cancelAll();
    EXPECT_TRUE(waitUntil(15.0, [this] { return isAtRest(); }));
    EXPECT_TRUE(client_.areCommandsFinite());
    EXPECT_LE(client_.topSpeed(), 1.0 + 1e-9);
  }

  void drive() {
    const bool is_near = position_.x() > 60.0;  // there and back
    client_.send(is_near ? 10.0 : 80.0, is_near ? 10.0 : 80.0);
    ASSERT_TRUE(waitUntil(40.0, [this] { return speed_ > 0.8; })) << client_.status().stop_cause;
  }

  bool isAtRest() const { return speed_ < 0.01; }

  // A node of that name in another process than `before`.
  pid_t waitForNode(const std::string& name, pid_t before) {
    pid_t process = 0;
    waitUntil(20.0, [&] {
      process = processOf(name);
      return process != 0 && process != before;
    });
    return process;
  }

  static bool waitUntil(double timeout, const std::function<bool()>& condition) {
    return NavigationClient::waitUntil(timeout, condition);
  }

  void onOdometry(const nav_msgs::Odometry& odometry) {
    const geometry_msgs::Vector3& velocity = odometry.twist.twist.linear;
    speed_ = std::hypot(velocity.x, velocity.y);
    position_ = {odometry.pose.pose.position.x, odometry.pose.pose.position.y};
  }
  void onGuardStatus(const GuardStatus& status) { guard_ = status; }

  ros::NodeHandle node_;
  ros::Subscriber odometry_, guard_status_;
  double speed_ = 0.0;
  Point position_{0.0, 0.0};  // in odom, which begins where the robot began
  GuardStatus guard_;
  NavigationClient client_;
};

TEST_F(ProcessesTest, KilledPlanner) {
  const pid_t process = processOf("planner_node");
  ASSERT_NE(process, 0);
  kill(process, SIGKILL);
  expectRest({"planner_node killed (SIGKILL)", 1.75}, [this] { return isAtRest(); });
  EXPECT_EQ(guard_.stop_cause, "the planner is silent");
  EXPECT_NE(waitForNode("planner_node", process), process);
  NavigationClient next;  // the next planner knows nothing of the goal
  ASSERT_TRUE(next.connect());
  EXPECT_TRUE(isAtRest());
  waitUntil(1.0, [] { return false; });
  drive();
}

TEST_F(ProcessesTest, StoppedPlanner) {
  {
    const StoppedProcess planner(processOf("planner_node"));
    expectRest({"planner_node stopped (SIGSTOP)", 1.75}, [this] { return isAtRest(); });
    EXPECT_EQ(guard_.stop_cause, "the planner is silent");
    waitUntil(1.0, [] { return false; });
    EXPECT_TRUE(isAtRest());
  }
  EXPECT_TRUE(waitUntil(20.0, [this] { return speed_ > 0.8; })) << "it goes on";
}

// Runs for 0.05 s after every 0.9 s, as one that spins or swaps: its decisions come too late.
TEST_F(ProcessesTest, PlannerThatHardlyRuns) {
  const pid_t process = processOf("planner_node");
  ASSERT_NE(process, 0);
  std::atomic<bool> is_over{false};
  std::thread stutter([&] {
    while (!is_over) {
      const StoppedProcess planner(process);
      std::this_thread::sleep_for(std::chrono::milliseconds(900));
      kill(process, SIGCONT);
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
  });
  expectRest({"planner_node hardly runs (SIGSTOP for 0.9 s of every 0.95 s)", 2.25},
             [this] { return isAtRest(); });
  is_over = true;
  stutter.join();
  EXPECT_TRUE(waitUntil(30.0, [this] { return speed_ > 0.8; })) << "it goes on";
}

// What the next guard finds: a base in motion and a planner that commands on.
TEST_F(ProcessesTest, KilledGuardIsReplaced) {
  const pid_t process = processOf("velocity_guard");
  ASSERT_NE(process, 0);
  kill(process, SIGKILL);
  const pid_t next = waitForNode("velocity_guard", process);
  ASSERT_NE(next, 0);
  ASSERT_NE(next, process);
  const ros::Time begin = ros::Time::now();
  EXPECT_TRUE(waitUntil(
      20.0, [&] { return guard_.header.stamp > begin && guard_.state == GuardStatus::FORWARDING; }))
      << "the next one takes over: " << guard_.stop_cause;
  waitUntil(2.0, [] { return false; });  // what the killed one left has come to rest
  EXPECT_TRUE(waitUntil(10.0, [this] { return speed_ > 0.8; })) << guard_.stop_cause;
}

TEST_F(ProcessesTest, StoppedGuard) {
  {
    const StoppedProcess guard(processOf("velocity_guard"));
    expectRest({"velocity_guard stopped (SIGSTOP)", 2.0}, [this] { return isAtRest(); });
  }
  EXPECT_TRUE(waitUntil(20.0, [this] { return speed_ > 0.8; })) << "it goes on";
}

// Both at once, and nobody to replace the guard in time: what is left is the watchdog of the base.
TEST_F(ProcessesTest, StoppedPlannerAndGuard) {
  {
    const StoppedProcess planner(processOf("planner_node"));
    const StoppedProcess guard(processOf("velocity_guard"));
    expectRest({"planner_node and velocity_guard stopped", 2.0}, [this] { return isAtRest(); });
  }
  EXPECT_TRUE(waitUntil(20.0, [this] { return speed_ > 0.8; })) << "it goes on";
}

TEST_F(ProcessesTest, GuardThatIsToldToEndBrakesFirst) {
  const pid_t process = processOf("velocity_guard");
  ASSERT_NE(process, 0);
  const StoppedProcess planner(processOf("planner_node"));
  kill(process, SIGINT);
  expectRest({"velocity_guard ended (SIGINT)", 1.5}, [this] { return isAtRest(); });
  EXPECT_TRUE(client_.waitForRest(1.0)) << "the last command is a zero";
}

// The base is braked before the planner ends, and no goal that comes meanwhile is accepted.
TEST_F(ProcessesTest, PlannerWhoseTerminalIsClosedBrakesAndRefusesGoals) {
  const pid_t process = processOf("planner_node");
  ASSERT_NE(process, 0);
  NavigationClient late;
  ASSERT_TRUE(late.connect());
  kill(process, SIGHUP);
  waitUntil(0.3, [] { return false; });
  late.send(40.0, 40.0);
  expectRest({"planner_node ended by its terminal (SIGHUP)", 1.2}, [this] { return isAtRest(); });
  EXPECT_TRUE(late.waitForEnd(1.0));
  EXPECT_EQ(late.state(), NavigationClient::State::REJECTED);
  EXPECT_EQ(late.text(), "the planner is being shut down");
  EXPECT_NE(waitForNode("planner_node", process), process);
}

}  // namespace
}  // namespace pomdp_crowd_nav

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "processes_rostest");
  return RUN_ALL_TESTS();
}
