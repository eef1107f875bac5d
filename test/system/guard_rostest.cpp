// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "fault_probe.h"
#include "guarded_robot.h"
#include "pomdp_crowd_nav/params/load_params.h"
#include "pomdp_crowd_nav/params/yaml_param_reader.h"

namespace pomdp_crowd_nav {
namespace {

// The guard of the profile movo, 1 m/s and 1 m/s^2, without any planner_node. Bounds are the age
// limit, 1.0 s of braking, and 0.4 s for messages on their way, periods of tracks (0.1 s), of
// guard, base and this test on a machine that is busy with something else.

VehicleParams movo() {
  YamlParamReader reader = YamlParamReader::fromFile(SOURCE_DIR "/config/profiles/movo.yaml");
  return loadNavigationParams(reader).planning.model.vehicle;
}

class GuardTest : public testing::Test {
 protected:
  GuardTest() {
    status_subscriber_ = node_.subscribe("velocity_guard/status", 10, &GuardTest::onStatus, this);
  }

  void SetUp() override { drive(); }

  void TearDown() override {
    EXPECT_TRUE(robot_.areCommandsFinite());
    EXPECT_LE(robot_.topCommand(), 1.0 + 1e-9);
    EXPECT_LE(robot_.topYawRate(), 1.0 + 1e-9);
  }

  void drive(double x = 1.0) {
    robot_.command(x, 0.0, 0.0);
    ASSERT_TRUE(waitUntil(10.0, [&] { return robot_.speed() > 0.95 * x; })) << status_.stop_cause;
  }

  // Whether the base is at rest; notes whether the guard has named the cause.
  std::function<bool()> restsFor(const std::string& cause) {
    cause_ = cause;
    is_named_ = false;
    return [this] {
      isNamed();
      return robot_.isAtRest();
    };
  }

  bool isNamed() {
    is_named_ = is_named_ || status_.stop_cause.find(cause_) != std::string::npos;
    return is_named_;
  }

  void expectCause() {
    EXPECT_TRUE(waitUntil(1.0, [this] { return isNamed(); }))
        << "expected: " << cause_ << ", got: " << status_.stop_cause;
  }

  static bool waitUntil(double timeout, const std::function<bool()>& condition) {
    return NavigationClient::waitUntil(timeout, condition);
  }

  void onStatus(const GuardStatus& status) { status_ = status; }

  ros::NodeHandle node_;
  ros::Subscriber status_subscriber_;
  GuardStatus status_;
  std::string cause_;
  bool is_named_ = false;
  GuardedRobot robot_{movo()};
};

TEST_F(GuardTest, SilentPlanner) {
  robot_.is_planner_silent = true;
  expectRest({"guard: planner silent", 1.65}, restsFor("planner is silent"));
  expectCause();
  EXPECT_TRUE(waitUntil(2.0, [this] { return status_.state == GuardStatus::IDLE; }));
  const int commands = robot_.commandCount();
  waitUntil(0.5, [] { return false; });
  EXPECT_EQ(robot_.commandCount(), commands) << "a guard without a planner is silent at rest";
  drive();
}

TEST_F(GuardTest, CommandThatIsNotFinite) {
  robot_.command(std::nan(""), 0.0, 0.0);
  expectRest({"guard: command not finite", 1.4}, restsFor("command is not finite"));
  expectCause();
  EXPECT_GT(status_.bad_commands, 0u);
  drive();
}

TEST_F(GuardTest, CommandOverTheLimitsIsCut) {
  robot_.command(30.0, 40.0, -7.0);
  EXPECT_TRUE(waitUntil(3.0, [this] { return status_.state == GuardStatus::LIMITING; }));
  waitUntil(2.0, [] { return false; });
  EXPECT_NEAR(robot_.speed(), 1.0, 0.02);
  EXPECT_GT(status_.wanted_speed, 49.0);
}

TEST_F(GuardTest, SilentOdometry) {
  robot_.is_odometry_silent = true;
  expectRest({"guard: odometry silent", 1.9}, restsFor("odometry is silent"));
  expectCause();
  robot_.is_odometry_silent = false;
  drive();
}

TEST_F(GuardTest, OdometryThatIsNotFinite) {
  robot_.is_odometry_nan = true;
  expectRest({"guard: odometry not finite", 1.9}, restsFor("odometry is not finite"));
  expectCause();
  EXPECT_GT(status_.bad_odometry, 0u);
}

TEST_F(GuardTest, SilentPeople) {
  robot_.are_people_silent = true;
  expectRest({"guard: people silent", 2.4}, restsFor("people are silent"));
  expectCause();
  robot_.are_people_silent = false;
  drive();
}

TEST_F(GuardTest, DeadLocalisation) {
  robot_.is_transform_silent = true;
  expectRest({"guard: localisation dead", 2.6}, restsFor("no transform"));
  expectCause();
  EXPECT_GT(status_.transform_failures, 0u);
  EXPECT_EQ(status_.people_fault, "/tracked_persons: from 'map' to 'odom'");
  robot_.is_transform_silent = false;
  drive();
}

// With inputs that come on, the base brakes only until they are there anew; so they do not.
TEST_F(GuardTest, ClockThatJumpsBack) {
  robot_.are_people_silent = true;
  robot_.clock_offset = robot_.clock_offset - 10.0;
  expectRest({"guard: clock back 10 s", 1.4}, restsFor("clock jumped back"));
  expectCause();
  robot_.are_people_silent = false;
  drive();
}

// A planner gone mad that drives at full speed at somebody who stands there.
TEST_F(GuardTest, PersonInTheWay) {
  const double radius = movo().radius;
  robot_.putPerson(robot_.ahead(3.0, 0.3));
  expectRest({"guard: planner drives at a person", 4.4}, restsFor("person is in"));
  expectCause();
  EXPECT_EQ(status_.blocking_person, 7);
  EXPECT_GT(robot_.nearest(), radius + 0.3 - 0.05) << "of the centres";
  RecordProperty("nearest_m", fmt::format("{:.2f}", robot_.nearest()));
  waitUntil(2.0, [] { return false; });
  EXPECT_TRUE(robot_.isAtRest()) << "it stays there";
  robot_.command(-0.5, 0.0, 0.0);
  EXPECT_TRUE(waitUntil(3.0, [this] { return robot_.speed() > 0.4; })) << "and may back out";
}

// A robot whose only tracker speaks people_msgs.
TEST_F(GuardTest, PersonOfPeopleMsgsInTheWay) {
  robot_.is_tracker_of_people_msgs = true;
  waitUntil(2.0, [] { return false; });
  EXPECT_GT(robot_.speed(), 0.9) << status_.stop_cause;
  robot_.putPerson(robot_.ahead(3.0, 0.3));
  expectRest({"guard: person of people_msgs in the way", 4.4}, restsFor("person is in"));
  expectCause();
  EXPECT_EQ(status_.blocking_person, 7);
  EXPECT_GT(robot_.nearest(), movo().radius + 0.3 - 0.05) << "of the centres";
}

// Further than transform_tolerance, and no transform is stamped ahead.
TEST_F(GuardTest, StampsALittleAheadAreNow) {
  const unsigned failures = status_.transform_failures;
  robot_.stamps_ahead = 0.3;
  expectDriveOn({"guard: stamps 0.3 s ahead", 0.4}, 3.0);
  EXPECT_EQ(status_.transform_failures, failures) << status_.people_fault;
}

// Odometry, people and transforms. The difference of such a stamp and ROS time is no ros::Duration,
// and a later one no ros::Time: either throws. What comes afterwards counts again.
TEST_F(GuardTest, StampsOfTheYear2106) {
  robot_.are_stamps_absurd = true;
  expectRest({"guard: stamps of the year 2106", 1.9}, restsFor("odometry is refused"));
  expectCause();
  EXPECT_GT(status_.refused_people, 0u);
  EXPECT_EQ(status_.people_fault, "/tracked_persons: stamped in the future");
  robot_.are_stamps_absurd = false;
  drive();
}

}  // namespace
}  // namespace pomdp_crowd_nav

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "guard_rostest");
  return RUN_ALL_TESTS();
}
