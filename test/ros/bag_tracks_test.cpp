// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/ros/bag_tracks.h"

#include <gtest/gtest.h>
#include <rosbag/bag.h>

#include "../sim/temporary_file.h"
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

class BagTracks : public ::testing::Test {
 protected:
  // Recorded at other times than those of the stamps, and not in their order.
  void write(const std::string& topic, const std::string& frame) {
    rosbag::Bag bag(file_.path(), rosbag::bagmode::Write);
    bag.write(topic, ros::Time(10.0), sweep(2.0, frame, 0.5));
    bag.write(topic, ros::Time(11.0), sweep(1.0, frame, 0.0));
    std_msgs::Header other;
    bag.write("/other", ros::Time(12.0), other);
  }

  std::vector<TrackSample> read() {
    return readTracksBag({file_.path(), "tracked_persons", "map"},
                         [this](size_t done, size_t total) {
                           done_ = done;
                           total_ = total;
                         });
  }

  std::string message() {
    return messageOf([this] { read(); });
  }

  TemporaryFile file_{"tracks.bag", ""};
  size_t done_ = 0, total_ = 0;
};

TEST_F(BagTracks, AreInOrderOfTime) {
  write("/tracked_persons", "/map");
  const std::vector<TrackSample> samples = read();
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

TEST_F(BagTracks, SayWhatIsWrong) {
  EXPECT_EQ(message().rfind(file_.path() + ": ", 0), 0U) << message();  // no bag
  write("/people", "map");
  EXPECT_EQ(message(), file_.path() + ": there is no topic 'tracked_persons'");
  write("tracked_persons", "odom");
  EXPECT_EQ(message(),
            file_.path() + ": topic 'tracked_persons': expected the frame 'map', got 'odom'");
  rosbag::Bag(file_.path(), rosbag::bagmode::Write)
      .write("tracked_persons", ros::Time(1.0), std_msgs::Header());
  EXPECT_EQ(message(), file_.path() +
                           ": topic 'tracked_persons': expected TrackedPersons, got "
                           "std_msgs/Header");
}

}  // namespace
}  // namespace pomdp_crowd_nav
