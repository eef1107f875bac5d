// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <iostream>

#include "diagnostics_listener.h"
#include "fake_robot.h"
#include "fault_probe.h"
#include "foreign_message.h"
#include "pomdp_crowd_nav/ros/map_conversions.h"
#include "pomdp_crowd_nav/sim/world_file.h"

namespace pomdp_crowd_nav {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

nav_msgs::OccupancyGrid worldGrid() {
  std_msgs::Header header;
  header.frame_id = "map";
  return toMessage(loadWorld(SOURCE_DIR "/config/worlds/scenario_1.yaml").map(), 0.5, header);
}

// People beside the way, each where its number says, so that they stop nobody.
std::vector<TrackedPerson> bystanders(int count) {
  std::vector<TrackedPerson> people(static_cast<size_t>(count));
  for (int i = 0; i < count; ++i) {
    TrackedPerson& person = people[static_cast<size_t>(i)];
    person.track_id = static_cast<std::uint64_t>(i);
    person.pose.pose.position.x = 60.0 + 0.3 * (i % 100);
    person.pose.pose.position.y = 1.0 + 0.3 * (i / 100 % 100);
  }
  return people;
}

// A tracker that sees 10 000 people five times a second, until it is interrupted. It is this
// program again, in a process of its own: 35 MB/s through the test's connections would delay what
// it measures.
constexpr const char* kCrowdArgument = "--crowd";

int runCrowd() {
  ros::NodeHandle node;
  ros::Publisher publisher = node.advertise<Foreign<TrackedPersons>>("tracked_persons", 1);
  Foreign<TrackedPersons> crowd;
  crowd.message.header.frame_id = "map";
  crowd.message.tracks = bystanders(10000);
  while (ros::ok()) {
    ros::WallDuration(0.2).sleep();
    crowd.message.header.stamp = ros::Time::now();
    publisher.publish(crowd);
  }
  return 0;
}

class CrowdProcess {
 public:
  CrowdProcess() {
    std::string program = "/proc/self/exe", argument = kCrowdArgument, name = "__name:=crowd";
    char* arguments[] = {program.data(), argument.data(), name.data(), nullptr};
    EXPECT_EQ(posix_spawn(&pid_, program.c_str(), nullptr, nullptr, arguments, environ), 0);
  }
  ~CrowdProcess() {
    kill(pid_, SIGINT);
    waitpid(pid_, nullptr, 0);
  }

 private:
  pid_t pid_ = 0;
};

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
  robot_.transform_spoiler.set([](geometry_msgs::TransformStamped& t) {
    t.header.stamp = ros::Time(std::numeric_limits<std::uint32_t>::max(), 999999999);
  });
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

// The rest stops nothing: commands go on at 20 Hz.

TEST_F(InputsTest, TenThousandTracksDelayNothing) {
  const CrowdProcess crowd;
  robot_.are_people_silent = true;
  EXPECT_TRUE(client_.waitUntil(15.0, [&] {
    return client_.status().people >= 1000 && client_.commandedSpeed() > 0.3;
  })) << client_.status().stop_cause;
  client_.forgetCauses();
  const PlannerStatus before = client_.status();
  expectDriveOn({"10 000 tracks", 0.4}, 6.0);
  const PlannerStatus after = client_.status();
  EXPECT_GE(after.decisions - before.decisions, 6u);  // of 12
  EXPECT_GE(after.surplus_people - before.surplus_people, 9000u);
  robot_.are_people_silent = false;
}

TEST_F(InputsTest, IdsThatChangeAllTheTimeStopNothing) {
  std::uint64_t first = 0;
  robot_.people_spoiler.set([&first](TrackedPersons& persons) {
    persons.tracks = bystanders(20);
    for (TrackedPerson& person : persons.tracks) person.track_id += first;
    first += 20;
  });
  expectDriveOn({"ids that switch in every message", 0.4}, 3.0);
  EXPECT_GE(client_.status().people, 20u);
  EXPECT_LE(client_.status().people, 200u);  // those of the last sweeps may be remembered
  robot_.people_spoiler.set({});
}

TEST_F(InputsTest, OfTwoTracksWithOneIdTheLastCounts) {
  const unsigned before = client_.status().duplicate_ids;
  robot_.people_spoiler.set([](TrackedPersons& persons) {
    persons.tracks = bystanders(20);
    for (TrackedPerson& person : persons.tracks) person.track_id /= 2;
  });
  expectDriveOn({"ids given twice", 0.4}, 3.0);
  EXPECT_EQ(client_.status().people, 10u);
  EXPECT_GE(client_.status().duplicate_ids, before + 10);
  robot_.people_spoiler.set({});
}

TEST_F(InputsTest, APersonWithoutAPositionIsLeftOutAndCounted) {
  const unsigned before = client_.status().bad_people;
  robot_.people_spoiler.set([](TrackedPersons& persons) {
    persons.tracks = bystanders(3);
    persons.tracks[0].pose.pose.position.y = kInfinity;
    persons.tracks[1].twist.twist.linear.x = kNaN;
  });
  expectDriveOn({"some people not finite", 0.4}, 3.0);
  EXPECT_EQ(client_.status().people, 2u);
  EXPECT_GT(client_.status().bad_people, before);
  robot_.people_spoiler.set({});
}

TEST_F(InputsTest, StampsALittleAheadAreNow) {
  const unsigned before = client_.status().future_stamps;
  robot_.odometry_spoiler.set([](nav_msgs::Odometry& o) { o.header.stamp += ros::Duration(0.3); });
  robot_.people_spoiler.set([](TrackedPersons& p) { p.header.stamp += ros::Duration(0.3); });
  expectDriveOn({"stamps 0.3 s ahead", 0.4}, 3.0);
  EXPECT_EQ(client_.status().future_stamps, before);
  robot_.odometry_spoiler.set({});
  robot_.people_spoiler.set({});
}

TEST_F(InputsTest, DenormalNumbersAreZero) {
  robot_.odometry_spoiler.set([](nav_msgs::Odometry& o) {
    o.pose.pose.position.z = std::numeric_limits<double>::denorm_min();
    o.twist.twist.angular.z = std::numeric_limits<double>::denorm_min();
  });
  expectDriveOn({"denormal numbers", 0.4}, 3.0);
  robot_.odometry_spoiler.set({});
}

// Publishers of other packages, by type name and md5 of theirs.

People twoPeople() {
  People people;
  people.header.frame_id = "map";
  people.header.stamp = ros::Time::now();
  people.people.resize(2);
  people.people[0].name = "anna";
  people.people[0].position.x = 70.0;
  people.people[1].name = "8";
  people.people[1].position.x = 75.0;
  return people;
}

// A tracker that is there and sees nobody does not hide whom another one sees.
TEST_F(InputsTest, PublishersOfPeopleMsgsAreHeardWhileNobodyElseReportsAnybody) {
  robot_.people_spoiler.set([](TrackedPersons& persons) { persons.tracks = bystanders(4); });
  EXPECT_TRUE(client_.waitUntil(5.0, [&] { return client_.status().people == 4; }));
  const LogListener log;
  EXPECT_TRUE(client_.waitUntil(5.0, [&] { return log.isConnected(); }));
  ros::Publisher publisher = ros::NodeHandle().advertise<Foreign<People>>("people", 1);
  const auto publishUntil = [&](double timeout, const std::function<bool()>& condition) {
    int ticks = 0;
    return client_.waitUntil(timeout, [&] {
      if (++ticks % 5 == 0) publisher.publish(Foreign<People>{twoPeople()});
      return condition();
    });
  };
  EXPECT_TRUE(publishUntil(5.0, [&] { return log.has("people come on two topics"); }));
  EXPECT_EQ(client_.status().people_topic, "/tracked_persons");
  EXPECT_EQ(client_.status().people, 4u);

  robot_.people_spoiler.set({});
  EXPECT_TRUE(publishUntil(6.0, [&] { return client_.status().people_topic == "/people"; }));
  EXPECT_TRUE(publishUntil(6.0, [&] {
    return client_.status().state == PlannerStatus::DRIVING && client_.status().people == 2;
  })) << client_.status().stop_cause;
  EXPECT_LT(client_.status().people_age, 1.0);

  EXPECT_TRUE(
      client_.waitUntil(6.0, [&] { return client_.status().people_topic == "/tracked_persons"; }));
  EXPECT_TRUE(client_.waitForMotion(8.0)) << client_.status().stop_cause;
}

// As which type FakeRobot's publisher registers.
TEST_F(InputsTest, PublishersOfSpencerTrackingAreHeard) {
  EXPECT_STREQ(ros::message_traits::datatype<Foreign<TrackedPersons>>(),
               "spencer_tracking_msgs/TrackedPersons");
  robot_.people_spoiler.set([](TrackedPersons& persons) { persons.tracks = bystanders(4); });
  EXPECT_TRUE(client_.waitUntil(
      5.0, [&] { return client_.status().people == 4 && client_.status().people_age < 1.0; }));
  EXPECT_EQ(client_.status().people_topic, "/tracked_persons");
  robot_.people_spoiler.set({});
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
