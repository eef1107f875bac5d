// SPDX-License-Identifier: BSD-3-Clause
// Inputs that fail, and stop the base. inputs_drive_on.cpp has those that do not.
#include <gtest/gtest.h>

#include <string>

#include "crowd_process.h"
#include "inputs_test.h"

namespace pomdp_crowd_nav {
namespace {

TEST_F(InputsTest, SilentOdometryStopsTheBase) {
  robot_.is_odometry_silent = true;
  expectRest({"odometry silent", 1.8}, isAtRest());
  expectCause("odometry is silent", "odometry");
  robot_.is_odometry_silent = false;
  expectRecovery("odometry");
}

TEST_F(InputsTest, InputThatStaysAwayIsNamedInTheLog) {
  const LogListener log;
  robot_.is_odometry_silent = true;
  EXPECT_TRUE(client_.waitUntil(
      8.0, [&] { return log.has("waiting for input: odometry is silent or too old"); }));
  robot_.is_odometry_silent = false;
  EXPECT_TRUE(client_.waitForMotion(5.0)) << client_.status().stop_cause;
}

TEST_F(InputsTest, OdometryThatIsNotFiniteStopsTheBase) {
  robot_.is_odometry_nan = true;
  expectRest({"odometry not finite", 1.8}, isAtRest());
  expectCause("not finite", "odometry");
  robot_.is_odometry_nan = false;
  expectRecovery("odometry");
}

TEST_F(InputsTest, OdometryThatIsNotFiniteForAMomentIsCounted) {
  const unsigned before = client_.status().bad_odometry;
  robot_.is_odometry_nan = true;
  NavigationClient::waitUntil(0.1, [] { return false; });
  robot_.is_odometry_nan = false;
  EXPECT_TRUE(client_.waitUntil(3.0, [&] { return client_.status().bad_odometry > before; }));
  EXPECT_TRUE(client_.waitForMotion(5.0)) << client_.status().stop_cause;
  EXPECT_TRUE(client_.waitUntil(
      3.0, [&] { return diagnostics_.level("odometry") == DiagnosticsListener::Status::WARN; }));
  EXPECT_EQ(diagnostics_.value("odometry", "topic"), "/odom");
  EXPECT_EQ(diagnostics_.value("odometry", "frame"), "odom");
  EXPECT_GT(std::stod(diagnostics_.value("odometry", "rate [Hz]")), 20.0);
  EXPECT_LT(std::stod(diagnostics_.value("odometry", "age [s]")), 0.5);
}

TEST_F(InputsTest, OdometryOutOfRangeStopsTheBase) {
  robot_.odometry_spoiler.set([](nav_msgs::Odometry& o) { o.twist.twist.linear.x = 1.0e9; });
  expectRest({"odometry out of range", 1.8}, isAtRest());
  expectCause("out of range", "odometry");
  robot_.odometry_spoiler.set({});
  expectRecovery("odometry");
}

TEST_F(InputsTest, OdometryOfTheFutureStopsTheBase) {
  const unsigned before = client_.status().future_stamps;
  robot_.odometry_spoiler.set([](nav_msgs::Odometry& o) { o.header.stamp += ros::Duration(5.0); });
  expectRest({"odometry stamped 5 s ahead", 1.8}, isAtRest());
  expectCause("stamped in the future", "odometry");
  EXPECT_GT(client_.status().future_stamps, before);
  robot_.odometry_spoiler.set({});
  expectRecovery("odometry");
}

TEST_F(InputsTest, OdometryWithoutAStampStopsTheBase) {
  robot_.odometry_spoiler.set([](nav_msgs::Odometry& o) { o.header.stamp = ros::Time(); });
  expectRest({"odometry without a stamp", 1.8}, isAtRest());
  expectCause("no time stamp", "odometry");
  robot_.odometry_spoiler.set({});
  expectRecovery("odometry");
}

TEST_F(InputsTest, OdometryInAnUnknownFrameStopsTheBase) {
  const unsigned before = client_.status().transform_failures;
  robot_.odometry_spoiler.set([](nav_msgs::Odometry& o) { o.header.frame_id = "elsewhere"; });
  expectRest({"odometry in a frame without transform", 1.8}, isAtRest());
  expectCause("no transform", "odometry");
  EXPECT_GT(client_.status().transform_failures, before);
  robot_.odometry_spoiler.set({});
  expectRecovery("transforms");
}

TEST_F(InputsTest, OdometryWithoutAFrameStopsTheBase) {
  robot_.odometry_spoiler.set([](nav_msgs::Odometry& o) { o.header.frame_id.clear(); });
  expectRest({"odometry without a frame", 1.8}, isAtRest());
  expectCause("names no frame", "transforms");
  robot_.odometry_spoiler.set({});
  expectRecovery("odometry");
}

TEST_F(InputsTest, SilentPeopleStopTheBaseButNobodyAboutDoesNot) {
  robot_.are_people_silent = true;
  expectRest({"people silent", 2.3}, isAtRest());
  expectCause("people are silent", "people");
  robot_.are_people_silent = false;
  expectRecovery("people");
}

TEST_F(InputsTest, PeopleOfWhomNobodyHasAPositionStopTheBase) {
  robot_.people_spoiler.set([](TrackedPersons& persons) {
    persons.tracks = bystanders(3);
    for (TrackedPerson& person : persons.tracks) person.pose.pose.position.x = kNaN;
  });
  expectRest({"people all not finite", 2.3}, isAtRest());
  expectCause("not finite", "people");
  robot_.people_spoiler.set({});
  expectRecovery("people");
}

TEST_F(InputsTest, PeopleOfThePastStopTheBase) {
  robot_.people_spoiler.set([](TrackedPersons& p) { p.header.stamp -= ros::Duration(10.0); });
  expectRest({"people stamped 10 s ago", 2.3}, isAtRest());
  expectCause("people are", "people");
  robot_.people_spoiler.set({});
  expectRecovery("people");
}

TEST_F(InputsTest, SilentTransformStopsTheBase) {
  robot_.is_transform_silent = true;
  expectRest({"tf silent", 2.0}, isAtRest());
  expectCause("transform to the global frame is too old", "odometry");
  robot_.is_transform_silent = false;
  expectRecovery("transforms");
}

// tf2 drops such a transform, so that the last good one ages.
TEST_F(InputsTest, TransformThatIsNoNumberStopsTheBase) {
  robot_.transform_spoiler.set(
      [](geometry_msgs::TransformStamped& t) { t.transform.translation.x = kNaN; });
  expectRest({"tf not a number", 2.0}, isAtRest());
  expectCause("transform to the global frame is too old", "odometry");
  robot_.transform_spoiler.set({});
  expectRecovery("transforms");
}

// The last stamp that there is. Once tf2 has it, it throws at the next one, or prefers it for ever.
TEST_F(InputsTest, TransformOfTheYear2106StopsTheBase) {
  robot_.transform_spoiler.set(
      [](geometry_msgs::TransformStamped& t) { t.header.stamp = FakeRobot::endOfTime(); });
  expectRest({"tf of the year 2106", 2.0}, isAtRest());
  expectCause("transform to the global frame is too old", "odometry");
  robot_.transform_spoiler.set({});
  expectRecovery("transforms");
}

TEST_F(InputsTest, InfiniteTransformStopsTheBase) {
  robot_.transform_spoiler.set(
      [](geometry_msgs::TransformStamped& t) { t.transform.translation.x = kInfinity; });
  expectRest({"tf infinite", 1.8}, isAtRest());
  expectCause("transform to the global frame is not finite", "odometry");
  robot_.transform_spoiler.set({});
  expectRecovery("transforms");
}

TEST_F(InputsTest, SilentMapStopsTheBaseWhereMapsAge) {
  robot_.is_map_silent = true;
  expectRest({"map silent", 4.3}, isAtRest());
  expectCause("map is missing or too old", "map");
  robot_.is_map_silent = false;
  expectRecovery("map");
}

TEST_F(InputsTest, ClockThatJumpsBackStopsTheBaseAndTheTripGoesOn) {
  const unsigned before = client_.status().clock_jumps;
  robot_.clock_offset = robot_.clock_offset - 10.0;
  expectRest({"clock back 10 s", 1.3}, isAtRest());
  expectFreshStart("clock jumped");
  EXPECT_GT(client_.status().clock_jumps, before);
}

TEST_F(InputsTest, ClockThatJumpsAheadStopsTheBaseAndTheTripGoesOn) {
  robot_.clock_offset = robot_.clock_offset + 10.0;
  expectRest({"clock ahead 10 s", 1.3}, isAtRest());
  expectFreshStart("clock jumped");
}

TEST_F(InputsTest, ClockThatStandsStillStopsTheBase) {
  robot_.is_clock_frozen = true;
  expectRest({"clock stands still", 1.8}, isAtRest());
  expectCause("clock stands still", "clock");
  robot_.is_clock_frozen = false;
  expectRecovery("clock");
}

TEST_F(InputsTest, PoseThatJumpsStopsTheBaseAndTheTripGoesOn) {
  robot_.x_offset = 5.0;
  expectRest({"pose jumps 5 m", 1.3}, isAtRest());
  expectFreshStart("pose jumped");
}

}  // namespace
}  // namespace pomdp_crowd_nav

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "inputs_rostest");
  if (argc > 1 && std::string(argv[1]) == pomdp_crowd_nav::kCrowdArgument) {
    return pomdp_crowd_nav::runCrowd();
  }
  return RUN_ALL_TESTS();
}
