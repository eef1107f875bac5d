// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <memory>

#include "fault_probe.h"
#include "guarded_robot.h"
#include "pomdp_crowd_nav/params/load_params.h"
#include "pomdp_crowd_nav/params/yaml_param_reader.h"
#include "started_node.h"

namespace pomdp_crowd_nav {
namespace {

// How a guard of the profile movo, 1 m/s and 1 m/s^2, begins and ends, before a base that has no
// watchdog: what the guard leaves undone, nobody does. Bounds are the age limit, 1.0 s of braking,
// and 0.4 s as in guard_rostest.cpp; 2 s for a new process.

VehicleParams movo() {
  YamlParamReader reader = YamlParamReader::fromFile(SOURCE_DIR "/config/profiles/movo.yaml");
  return loadNavigationParams(reader).planning.model.vehicle;
}

class GuardLife : public testing::Test {
 protected:
  GuardLife() { robot_.has_watchdog = false; }

  void startAndDrive(StartedNode::Log log = StartedNode::Log::kShown) {
    guard_ = std::make_unique<StartedNode>(VELOCITY_GUARD, log);
    drive();
  }

  void drive() {
    robot_.command(1.0, 0.0, 0.0);
    ASSERT_TRUE(waitUntil(20.0, [&] { return robot_.speed() > 0.95; }));
  }

  void TearDown() override { EXPECT_TRUE(robot_.areCommandsFinite()); }

  static bool waitUntil(double timeout, const std::function<bool()>& condition) {
    return NavigationClient::waitUntil(timeout, condition);
  }

  GuardedRobot robot_{movo()};
  std::unique_ptr<StartedNode> guard_;
};

// As of a terminal that was halted with Ctrl-S, or a pipe to a program that hangs.
TEST_F(GuardLife, LogThatNobodyReads) {
  startAndDrive(StartedNode::Log::kBlocked);
  robot_.are_people_silent = true;
  expectRest({"guard: its log is held up", 2.4}, [this] { return robot_.isAtRest(); });
  robot_.are_people_silent = false;
  drive();
}

TEST_F(GuardLife, NewGuardBesideADeadPlanner) {
  startAndDrive();
  robot_.is_planner_silent = true;
  guard_->kill(SIGKILL);
  guard_ = std::make_unique<StartedNode>(VELOCITY_GUARD);
  expectRest({"planner and velocity_guard killed, a new guard", 3.65},
             [this] { return robot_.isAtRest(); });
  waitUntil(1.0, [] { return false; });
  EXPECT_TRUE(robot_.isAtRest());
  const int commands = robot_.commandCount();
  waitUntil(0.5, [] { return false; });
  EXPECT_EQ(robot_.commandCount(), commands) << "then it is silent";
  drive();
}

TEST_F(GuardLife, ClosedTerminal) {
  startAndDrive();
  robot_.is_planner_silent = true;
  guard_->kill(SIGHUP);
  expectRest({"velocity_guard ended by its terminal (SIGHUP)", 1.5},
             [this] { return robot_.isAtRest(); });
  int status = -1;
  EXPECT_TRUE(waitUntil(5.0, [&] {
    status = guard_->exitStatus();
    return status >= 0;
  }));
  EXPECT_EQ(status, 0);
}

}  // namespace
}  // namespace pomdp_crowd_nav

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "guard_life_rostest");
  return RUN_ALL_TESTS();
}
