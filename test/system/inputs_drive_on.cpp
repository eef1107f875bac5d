// SPDX-License-Identifier: BSD-3-Clause
// Inputs that stop nothing, because they are odd, too many or of another package: commands go on at
// 20 Hz. Part of inputs_rostest.
#include <gtest/gtest.h>

#include <functional>
#include <vector>

#include "crowd_process.h"
#include "foreign_message.h"
#include "inputs_test.h"

namespace pomdp_crowd_nav {
namespace {

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
