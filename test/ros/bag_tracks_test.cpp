// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/ros/bag_tracks.h"

#include <gtest/gtest.h>
#include <rosbag/bag.h>
#include <tf2_msgs/TFMessage.h>

#include <cmath>

#include "../sim/temporary_file.h"
#include "../system/foreign_message.h"
#include "pomdp_crowd_nav/ros/conversions.h"
#include "pomdp_crowd_nav/ros/messages.h"

namespace pomdp_crowd_nav {
namespace {

TrackedPersons sweep(double time, const std::string& frame, double x) {
  TrackedPersons message;
  message.header.stamp = ros::Time(time);
  message.header.frame_id = frame;
  for (int id = 1; id <= 2; ++id) {
    TrackedPerson person;
    person.track_id = static_cast<std::uint64_t>(id);
    person.pose.pose.position.x = x + id;
    person.pose.pose.orientation.w = 1.0;
    message.tracks.push_back(person);
  }
  return message;
}

// As people_msgs sends it.
Foreign<People> crowd(double time, const std::string& frame, double x) {
  Foreign<People> foreign;
  foreign.message.header.stamp = ros::Time(time);
  foreign.message.header.frame_id = frame;
  Person person;
  person.name = "7";
  person.position.x = x;
  foreign.message.people.push_back(person);
  return foreign;
}

tf2_msgs::TFMessage transform(double time, const std::string& parent, const std::string& child,
                              const Pose& pose) {
  tf2_msgs::TFMessage message;
  message.transforms.resize(1);
  message.transforms[0].header.stamp = ros::Time(time);
  message.transforms[0].header.frame_id = parent;
  message.transforms[0].child_frame_id = child;
  message.transforms[0].transform = toTransform(pose);
  return message;
}

class BagTracksTest : public ::testing::Test {
 protected:
  // Recorded at other times than those of the stamps, and not in their order.
  void write(const std::string& topic, const std::string& frame) {
    rosbag::Bag bag(file_.path(), rosbag::bagmode::Write);
    bag.write(topic, ros::Time(10.0), sweep(2.0, frame, 0.5));
    bag.write(topic, ros::Time(11.0), sweep(1.0, frame, 0.0));
    std_msgs::Header other;
    bag.write("/other", ros::Time(12.0), other);
  }

  BagTracks read(const std::string& topic = "tracked_persons", const std::string& frame = "map") {
    return readTracksBag({file_.path(), topic, frame}, [this](size_t done, size_t total) {
      done_ = done;
      total_ = total;
    });
  }

  // A scanner fixed to a base that turns left by pi / 2 within a second, while odom drifts away.
  void writeScans() {
    rosbag::Bag bag(file_.path(), rosbag::bagmode::Write);
    const ros::Time recorded(500.0);
    bag.write("/tf_static", recorded, transform(3.0, "base", "/scanner", {Point(1.0, 0.0), 0.0}));
    for (const double time : {100.0, 101.0, 101.0}) {
      bag.write("tf", recorded,
                transform(time, "odom", "base", {Point(0.0, 2.0), (time - 100.0) * M_PI_2}));
    }
    bag.write("/tf", recorded, transform(99.0, "map", "odom", {Point(10.0, 0.0), 0.0}));
    bag.write("/tf", recorded, transform(103.0, "map", "odom", {Point(14.0, 0.0), 0.0}));
    for (const double time : {101.0, 99.5, 100.5}) {
      bag.write("people", recorded, crowd(time, "/scanner", 2.0));
    }
  }

  std::string message() {
    return messageOf([this] { read(); });
  }

  TemporaryFile file_{"tracks.bag", ""};
  size_t done_ = 0, total_ = 0;
};

TEST_F(BagTracksTest, AreInOrderOfTime) {
  write("/tracked_persons", "/map");
  const std::vector<TrackSample> samples = read().samples;
  ASSERT_EQ(samples.size(), 4U);
  EXPECT_EQ(samples[0].time, 1.0);
  EXPECT_EQ(samples[0].id, 1);
  EXPECT_EQ(samples[0].position, Point(1.0, 0.0));
  EXPECT_EQ(samples[3].time, 2.0);
  EXPECT_EQ(samples[3].id, 2);
  EXPECT_EQ(samples[3].position, Point(2.5, 0.0));
  EXPECT_EQ(done_, 2U);
  EXPECT_EQ(total_, 2U);
}

TEST_F(BagTracksTest, OfPeopleMsgsAreRead) {
  rosbag::Bag(file_.path(), rosbag::bagmode::Write)
      .write("/people", ros::Time(5.0), crowd(5.0, "map", 3.0));
  const std::vector<TrackSample> samples = read("people").samples;
  ASSERT_EQ(samples.size(), 1U);
  EXPECT_EQ(samples[0].id, 7);
  EXPECT_EQ(samples[0].time, 5.0);
  EXPECT_EQ(samples[0].position, Point(3.0, 0.0));
}

TEST_F(BagTracksTest, AreBroughtIntoTheFrameByTheTransformsOfTheirTime) {
  writeScans();
  const BagTracks tracks = read("people");
  EXPECT_EQ(tracks.messages, 3U);
  EXPECT_EQ(tracks.left_out, 1U) << "where the base was before 100.0 s nobody says";
  ASSERT_EQ(tracks.samples.size(), 2U);
  const double diagonal = 3.0 * M_SQRT1_2;
  EXPECT_EQ(tracks.samples[0].time, 100.5);
  EXPECT_LT((tracks.samples[0].position - Point(11.5 + diagonal, 2.0 + diagonal)).norm(), 1e-6);
  EXPECT_LT((tracks.samples[1].position - Point(12.0, 5.0)).norm(), 1e-6);
}

TEST_F(BagTracksTest, AreBroughtIntoAnotherFrameThanTheMap) {
  writeScans();
  const BagTracks tracks = read("people", "/odom");
  ASSERT_EQ(tracks.samples.size(), 2U);
  EXPECT_LT((tracks.samples[1].position - Point(0.0, 5.0)).norm(), 1e-6);
  EXPECT_EQ(messageOf([this] { read("people", "hall"); }),
            file_.path() +
                ": topic 'people': the bag has no transform from the frame 'scanner' to 'hall' at "
                "the time of any message");
}

TEST_F(BagTracksTest, SayWhatIsWrong) {
  EXPECT_EQ(message().rfind(file_.path() + ": ", 0), 0U) << message();  // no bag
  write("/people", "map");
  EXPECT_EQ(message(), file_.path() + ": there is no topic 'tracked_persons'");
  write("tracked_persons", "odom");
  EXPECT_EQ(message(), file_.path() +
                           ": topic 'tracked_persons': the bag has no transform from the frame "
                           "'odom' to 'map' at the time of any message");
  rosbag::Bag(file_.path(), rosbag::bagmode::Write)
      .write("tracked_persons", ros::Time(1.0), std_msgs::Header());
  EXPECT_EQ(message(), file_.path() +
                           ": topic 'tracked_persons': expected TrackedPersons or People, got "
                           "std_msgs/Header");
}

}  // namespace
}  // namespace pomdp_crowd_nav
