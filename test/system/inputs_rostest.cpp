// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "fake_robot.h"

namespace pomdp_crowd_nav {
namespace {

// A robot on its way; every test makes one of its inputs fail and then lets it come back.
class InputsTest : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(client_.connect());
    client_.send(80.0, 80.0);
    ASSERT_TRUE(client_.waitForMotion(30.0)) << client_.status().stop_cause;
  }

  void TearDown() override {
    client_.cancel();
    EXPECT_TRUE(client_.waitForEnd(10.0));
    EXPECT_TRUE(client_.areCommandsFinite());
  }

  FakeRobot robot_;
  NavigationClient client_;
};

TEST_F(InputsTest, SilentOdometryStopsTheBase) {
  robot_.is_odometry_silent = true;
  EXPECT_TRUE(client_.waitForStop(3.0, "odometry is silent")) << client_.status().stop_cause;
  EXPECT_EQ(client_.status().state, PlannerStatus::WAITING_FOR_INPUT);
  robot_.is_odometry_silent = false;
  EXPECT_TRUE(client_.waitForMotion(5.0)) << client_.status().stop_cause;
}

TEST_F(InputsTest, InputThatStaysAwayIsNamedInTheLog) {
  const LogListener log;
  robot_.is_odometry_silent = true;
  EXPECT_TRUE(client_.waitUntil(
      8.0, [&] { return log.has("waiting for input: odometry is silent or too old"); }));
  robot_.is_odometry_silent = false;
  EXPECT_TRUE(client_.waitForMotion(5.0)) << client_.status().stop_cause;
}

TEST_F(InputsTest, SilentPeopleStopTheBaseButNobodyAboutDoesNot) {
  robot_.are_people_silent = true;
  EXPECT_TRUE(client_.waitForStop(4.0, "people are silent")) << client_.status().stop_cause;
  robot_.are_people_silent = false;
  EXPECT_TRUE(client_.waitForMotion(6.0)) << client_.status().stop_cause;
}

TEST_F(InputsTest, MissingTransformStopsTheBase) {
  robot_.is_transform_silent = true;
  EXPECT_TRUE(client_.waitForStop(4.0, "no transform")) << client_.status().stop_cause;
  EXPECT_GT(client_.status().transform_failures, 0u);
  robot_.is_transform_silent = false;
  EXPECT_TRUE(client_.waitForMotion(5.0)) << client_.status().stop_cause;
}

TEST_F(InputsTest, OdometryThatIsNotFiniteIsCountedAndStopsTheBaseIfItLasts) {
  const unsigned before = client_.status().bad_odometry;
  robot_.is_odometry_nan = true;
  NavigationClient::waitUntil(0.1, [] { return false; });
  robot_.is_odometry_nan = false;
  EXPECT_TRUE(client_.waitUntil(3.0, [&] { return client_.status().bad_odometry > before; }));
  EXPECT_TRUE(client_.waitForMotion(5.0)) << client_.status().stop_cause;

  robot_.is_odometry_nan = true;
  EXPECT_TRUE(client_.waitForStop(3.0, "not finite")) << client_.status().stop_cause;
  robot_.is_odometry_nan = false;
  EXPECT_TRUE(client_.waitForMotion(5.0)) << client_.status().stop_cause;
}

TEST_F(InputsTest, ClockThatJumpsBackStopsTheBaseAndTheTripGoesOn) {
  robot_.clock_offset = robot_.clock_offset - 100.0;
  EXPECT_TRUE(client_.waitForRest(3.0));
  EXPECT_TRUE(client_.waitForMotion(8.0)) << client_.status().stop_cause;
}

TEST_F(InputsTest, PoseThatJumpsStopsTheBaseAndTheTripGoesOn) {
  robot_.x_offset = 5.0;
  EXPECT_TRUE(client_.waitUntil(2.0, [this] {
    return client_.status().stop_cause.find("pose jumped") != std::string::npos;
  }));
  EXPECT_TRUE(client_.waitForRest(2.0));
  EXPECT_TRUE(client_.waitForMotion(8.0)) << client_.status().stop_cause;
}

}  // namespace
}  // namespace pomdp_crowd_nav

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "inputs_rostest");
  return RUN_ALL_TESTS();
}
