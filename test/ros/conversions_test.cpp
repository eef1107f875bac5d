// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/ros/conversions.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "pomdp_crowd_nav/ros/odometry_input.h"

namespace pomdp_crowd_nav {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(Messages, TrackedPersonsConnectToSpencerPublishers) {
  EXPECT_STREQ(ros::message_traits::md5sum<TrackedPersons>(), "21c0b1a57c4933e68f39aa3802861828");
}

TEST(Messages, PeopleConnectToPublishersOfPeopleMsgs) {
  EXPECT_STREQ(ros::message_traits::md5sum<People>(), "18722f4b8db20cc2369740732357847b");
}

TEST(Messages, PauseServiceIsThatOfStdSrvs) {
  EXPECT_STREQ(ros::service_traits::md5sum<PauseService>(), "09fb03525b03e7ea1fd3992bafd87e16");
}

TEST(Messages, NamesOnTheWireAreUnchanged) {
  EXPECT_STREQ(ros::message_traits::datatype<CrowdBeliefMessage>(), "pomdp_crowd_nav/CrowdBelief");
  EXPECT_STREQ(ros::message_traits::datatype<EpisodeMetricsMessage>(),
               "pomdp_crowd_nav/EpisodeMetrics");
}

TEST(Transforms, InverseUndoes) {
  const Pose frame{Point(3.0, -2.0), 2.5};
  const Pose pose{Point(1.0, 4.0), -1.0};
  const Pose back = transformed(inverse(frame), transformed(frame, pose));
  EXPECT_NEAR((back.position - pose.position).norm(), 0.0, 1e-12);
  EXPECT_NEAR(back.heading, pose.heading, 1e-12);
}

TEST(Poses, SurviveTheWayThereAndBack) {
  for (const double heading : {-3.0, -1.0, 0.0, 0.5, 3.1}) {
    const auto pose = toPose(toMessage(Pose{Point(1.0, 2.0), heading}));
    ASSERT_TRUE(pose);
    EXPECT_NEAR(pose->heading, heading, 1e-12);
  }
}

TEST(Poses, WithoutRotationOrNotFiniteAreNone) {
  geometry_msgs::Pose pose;  // its quaternion is zero
  EXPECT_FALSE(toPose(pose));
  pose.orientation.w = 1.0;
  EXPECT_TRUE(toPose(pose));
  pose.position.x = kNaN;
  EXPECT_FALSE(toPose(pose));
  pose.position.x = 0.0;
  pose.orientation.z = kInfinity;
  EXPECT_FALSE(toPose(pose));
}

TEST(Odometry, TurnsTheTwistIntoTheGlobalFrame) {
  nav_msgs::Odometry odometry;
  odometry.pose.pose = toMessage(Pose{Point(1.0, 0.0), M_PI_2});
  odometry.twist.twist.linear.x = 0.5;
  const auto reading = toReading(odometry, Pose{Point(10.0, 10.0), M_PI_2});
  ASSERT_TRUE(reading);
  EXPECT_NEAR((reading->pose.position - Point(10.0, 11.0)).norm(), 0.0, 1e-12);
  EXPECT_NEAR((reading->velocity - Point(-0.5, 0.0)).norm(), 0.0, 1e-12);
}

TEST(Odometry, WithANumberThatIsNotFiniteIsNone) {
  nav_msgs::Odometry odometry;
  odometry.pose.pose.orientation.w = 1.0;
  EXPECT_TRUE(toReading(odometry, Pose{}));
  odometry.twist.twist.linear.y = kNaN;
  EXPECT_FALSE(toReading(odometry, Pose{}));
  odometry.twist.twist.linear.y = 0.0;
  odometry.twist.twist.angular.z = kInfinity;
  EXPECT_FALSE(toReading(odometry, Pose{}));
}

TEST(Odometry, WithNumbersTooLargeToBeAddedIsNone) {
  nav_msgs::Odometry odometry;
  odometry.pose.pose.orientation.w = 1.0;
  odometry.twist.twist.linear.x = odometry.twist.twist.linear.y = 1.7e308;
  EXPECT_FALSE(toReading(odometry, Pose{Point(0.0, 0.0), -M_PI_4}));
  odometry.twist.twist = geometry_msgs::Twist();
  odometry.pose.pose.position.x = 1.7e308;
  EXPECT_FALSE(toReading(odometry, Pose{Point(1.7e308, 0.0), 0.0}));
}

TEST(Tracks, KeepIdsAndLeaveOutPeopleWithoutAPosition) {
  TrackedPersons persons;
  persons.header.stamp = ros::Time(12.5);
  persons.tracks.resize(3);
  persons.tracks[0].track_id = 7;
  persons.tracks[0].pose.pose.position.x = 1.0;
  persons.tracks[0].twist.twist.linear.x = 1.0;
  persons.tracks[1].pose.pose.position.y = kNaN;
  persons.tracks[2].track_id = 9;
  persons.tracks[2].twist.twist.linear.x = kNaN;
  const TrackList list = toTracks(persons, Pose{Point(5.0, 0.0), M_PI});
  EXPECT_DOUBLE_EQ(list.stamp, 12.5);
  ASSERT_EQ(list.tracks.size(), 2u);
  EXPECT_EQ(list.tracks[0].id, 7);
  EXPECT_NEAR((list.tracks[0].position - Point(4.0, 0.0)).norm(), 0.0, 1e-12);
  EXPECT_NEAR((list.tracks[0].velocity - Point(-1.0, 0.0)).norm(), 0.0, 1e-12);
  EXPECT_EQ(list.tracks[1].velocity, Point(0.0, 0.0));
}

TEST(Tracks, OfPeopleAreThoseOfTrackedPersons) {
  People people;
  people.header.stamp = ros::Time(12.5);
  people.people.resize(3);
  people.people[0].name = "7";
  people.people[0].position.x = 1.0;
  people.people[0].velocity.x = 1.0;
  people.people[1].position.y = kNaN;
  people.people[2].name = "9";
  people.people[2].velocity.x = kInfinity;
  const TrackList list = toTracks(people, Pose{Point(5.0, 0.0), M_PI});
  EXPECT_DOUBLE_EQ(list.stamp, 12.5);
  ASSERT_EQ(list.tracks.size(), 2u);
  EXPECT_EQ(list.tracks[0].id, 7);
  EXPECT_NEAR((list.tracks[0].position - Point(4.0, 0.0)).norm(), 0.0, 1e-12);
  EXPECT_NEAR((list.tracks[0].velocity - Point(-1.0, 0.0)).norm(), 0.0, 1e-12);
  EXPECT_EQ(list.tracks[1].id, 9);
  EXPECT_EQ(list.tracks[1].velocity, Point(0.0, 0.0));
}

TEST(Tracks, NamesThatAreNumbersAreTheIds) {
  EXPECT_EQ(idOfName("0"), 0);
  EXPECT_EQ(idOfName("42"), 42);
  EXPECT_EQ(idOfName("9223372036854775807"), std::numeric_limits<std::int64_t>::max());
}

TEST(Tracks, OtherNamesHaveAnIdOfTheirOwnThatNeverChanges) {
  EXPECT_EQ(idOfName("person_1"), 7039522202407752820);
  EXPECT_NE(idOfName("person_1"), idOfName("person_2"));
  for (const char* name : {"", "-3", "7.5", "9223372036854775808", "anna", " 7"}) {
    EXPECT_GE(idOfName(name), std::int64_t{1} << 62) << name;
  }
}

TEST(Tracks, IdsAreNotNegative) {
  TrackedPersons persons;
  persons.tracks.resize(1);
  persons.tracks[0].track_id = std::numeric_limits<std::uint64_t>::max();
  EXPECT_GE(toTracks(persons, Pose{}).tracks.at(0).id, 0);
}

TEST(Odometry, DenormalNumbersAreZero) {
  nav_msgs::Odometry odometry;
  odometry.pose.pose.orientation.w = 1.0;
  odometry.pose.pose.position.x = std::numeric_limits<double>::denorm_min();
  odometry.twist.twist.linear.x = -1.0e-310;
  odometry.twist.twist.angular.z = 1.0e-320;
  const auto reading = toReading(odometry, Pose{});
  ASSERT_TRUE(reading);
  EXPECT_EQ(reading->pose.position.x(), 0.0);
  EXPECT_EQ(reading->velocity.x(), 0.0);
  EXPECT_EQ(reading->yaw_rate, 0.0);
}

TEST(Odometry, OutOfRangeIsToldFromWhatABaseCanDo) {
  VehicleParams vehicle;
  vehicle.max_speed = 1.0;
  vehicle.max_yaw_rate = 1.0;
  const ReadingRange range = readingRange(vehicle);
  RobotReading reading;
  reading.velocity = Point(3.0, 3.0);
  EXPECT_TRUE(isWithin(reading, range));
  reading.velocity = Point(4.0, 4.0);
  EXPECT_FALSE(isWithin(reading, range));
  reading.velocity = Point(0.0, 0.0);
  reading.pose.position = Point(0.0, -1.1e6);
  EXPECT_FALSE(isWithin(reading, range));
  reading.pose.position = Point(0.0, 9.9e5);
  EXPECT_TRUE(isWithin(reading, range));
  reading.yaw_rate = -5.1;
  EXPECT_FALSE(isWithin(reading, range));
  reading.yaw_rate = kNaN;
  EXPECT_FALSE(isWithin(reading, range));
}

TEST(Beliefs, SayAllProbabilities) {
  PersonBelief person{7, Point(1.0, 2.0), Point(0.5, 0.0), 1.0, IntentionBelief(2, 0.3, 0.1)};
  const CrowdBeliefMessage message =
      toMessage(CrowdBelief{0.0, {person}}, {Point(0.0, 0.0), Point(9.0, 0.0)}, std_msgs::Header());
  ASSERT_EQ(message.people.size(), 1u);
  const PersonBeliefMessage& belief = message.people[0];
  EXPECT_EQ(belief.id, 7);
  EXPECT_EQ(belief.probabilities, (std::vector<double>(2, 0.3)));
  EXPECT_DOUBLE_EQ(belief.probability_standing, 0.3);
  EXPECT_DOUBLE_EQ(belief.probability_elsewhere, 0.1);
}

TEST(Paths, PointAlongTheWay) {
  const nav_msgs::Path path =
      toMessage({Point(0.0, 0.0), Point(0.0, 1.0), Point(1.0, 1.0)}, std_msgs::Header());
  ASSERT_EQ(path.poses.size(), 3u);
  EXPECT_NEAR(toPose(path.poses[0].pose)->heading, M_PI_2, 1e-12);
  EXPECT_NEAR(toPose(path.poses[2].pose)->heading, 0.0, 1e-12);
  EXPECT_TRUE(toMessage(std::vector<Point>(), std_msgs::Header()).poses.empty());
}

}  // namespace
}  // namespace pomdp_crowd_nav
