// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <iostream>
#include <limits>
#include <string>
#include <vector>

#include "diagnostics_listener.h"
#include "fake_robot.h"
#include "fault_probe.h"
#include "pomdp_crowd_nav/ros/map_conversions.h"
#include "pomdp_crowd_nav/sim/world_file.h"

namespace pomdp_crowd_nav {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

inline nav_msgs::OccupancyGrid worldGrid() {
  std_msgs::Header header;
  header.frame_id = "map";
  return toMessage(loadWorld(SOURCE_DIR "/config/worlds/scenario_1.yaml").map(), 0.5, header);
}

// People beside the way, each where its number says, so that they stop nobody.
inline std::vector<TrackedPerson> bystanders(int count) {
  std::vector<TrackedPerson> people(static_cast<size_t>(count));
  for (int i = 0; i < count; ++i) {
    TrackedPerson& person = people[static_cast<size_t>(i)];
    person.track_id = static_cast<std::uint64_t>(i);
    person.pose.pose.position.x = 60.0 + 0.3 * (i % 100);
    person.pose.pose.position.y = 1.0 + 0.3 * (i / 100 % 100);
  }
  return people;
}

// A robot at full speed; every test makes one of its inputs fail and then lets it come back. How
// the bounds follow is in doc/safety.md.
class InputsTest : public testing::Test {
 protected:
  InputsTest() : robot_(worldGrid()) {}

  void SetUp() override {
    ASSERT_TRUE(client_.connect());
    client_.send(80.0, 80.0);
    ASSERT_TRUE(client_.waitForMotion(40.0, 0.9)) << client_.status().stop_cause;
    client_.forgetCauses();
  }

  void TearDown() override {
    client_.cancel();
    EXPECT_TRUE(client_.waitForEnd(10.0));
    EXPECT_TRUE(client_.areCommandsFinite());
    if (HasFailure()) std::cout << "causes reported:\n" << client_.causes() << std::endl;
  }

  auto isAtRest() {
    return [this] { return robot_.speed() == 0.0; };
  }

  // The status says why the base stands, and the input's diagnostic is in error.
  void expectCause(const std::string& cause, const std::string& task) {
    EXPECT_TRUE(client_.waitUntil(2.0, [&] { return client_.hasReported(cause); }))
        << client_.status().stop_cause;
    EXPECT_EQ(client_.status().state, PlannerStatus::WAITING_FOR_INPUT);
    EXPECT_TRUE(client_.waitUntil(
        3.0, [&] { return diagnostics_.level(task) == DiagnosticsListener::Status::ERROR; }))
        << task << " is at level " << diagnostics_.level(task);
    EXPECT_NE(diagnostics_.text(task).find(cause), std::string::npos) << diagnostics_.text(task);
  }

  // The base drives again, and the input's diagnostic is fine.
  void expectRecovery(const std::string& task) {
    EXPECT_TRUE(client_.waitForMotion(8.0)) << client_.status().stop_cause;
    EXPECT_TRUE(client_.waitUntil(
        6.0, [&] { return diagnostics_.level(task) == DiagnosticsListener::Status::OK; }))
        << task << ": " << diagnostics_.text(task);
  }

  // After a jump of clock or pose: why the base braked, and that it drives on.
  void expectFreshStart(const std::string& cause) {
    EXPECT_TRUE(client_.hasReported(cause)) << client_.status().stop_cause;
    EXPECT_TRUE(client_.waitForMotion(8.0)) << client_.status().stop_cause;
  }

  FakeRobot robot_;
  NavigationClient client_;
  DiagnosticsListener diagnostics_;
};

}  // namespace pomdp_crowd_nav
