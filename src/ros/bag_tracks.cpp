// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/ros/bag_tracks.h"

#include <fmt/format.h>
#include <rosbag/bag.h>
#include <rosbag/view.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <optional>
#include <stdexcept>
#include <utility>

#include "pomdp_crowd_nav/params/file_errors.h"
#include "pomdp_crowd_nav/ros/bag_transforms.h"
#include "pomdp_crowd_nav/ros/conversions.h"
#include "pomdp_crowd_nav/ros/frame_source.h"

namespace pomdp_crowd_nav {
namespace {

// What one message says, in its own frame.
struct Sweep {
  ros::Time stamp;
  std::string frame;
  TrackList people;
};

template <class Message>
std::optional<Sweep> toSweep(const rosbag::MessageInstance& instance) {
  const auto message = instance.instantiate<Message>();
  if (!message) return std::nullopt;
  return Sweep{message->header.stamp, withoutSlash(message->header.frame_id),
               toTracks(*message, Pose{})};
}

// In order of their stamps.
std::vector<Sweep> readSweeps(const rosbag::Bag& bag, const std::string& topic,
                              const std::function<void(size_t, size_t)>& progress) {
  rosbag::View view(bag, rosbag::TopicQuery({topic, "/" + topic}));
  std::vector<Sweep> sweeps;
  for (const rosbag::MessageInstance& instance : view) {
    std::optional<Sweep> sweep = toSweep<TrackedPersons>(instance);
    if (!sweep) sweep = toSweep<People>(instance);
    if (!sweep) {
      throw std::runtime_error(fmt::format("topic '{}': expected TrackedPersons or People, got {}",
                                           topic, instance.getDataType()));
    }
    sweeps.push_back(std::move(*sweep));
    progress(sweeps.size(), view.size());
  }
  if (sweeps.empty()) throw std::runtime_error(fmt::format("there is no topic '{}'", topic));
  std::stable_sort(sweeps.begin(), sweeps.end(),
                   [](const Sweep& a, const Sweep& b) { return a.stamp < b.stamp; });
  return sweeps;
}

// Poses of the messages' frames in the one that is wanted.
class FrameFinder {
 public:
  FrameFinder(const rosbag::Bag& bag, const std::string& wanted) : bag_(bag), wanted_(wanted) {}

  // None where the bag has no transform at that time. To be called in order of time.
  std::optional<Pose> find(const Sweep& sweep) {
    if (sweep.frame == wanted_) return Pose{};
    if (!transforms_) transforms_.emplace(bag_);
    const std::optional<Pose> pose = transforms_->find(wanted_, sweep.frame, sweep.stamp);
    is_known_[sweep.frame] |= pose.has_value();
    return pose;
  }

  // A frame of which nothing was found is not only unknown for a while.
  void throwIfUnknown(const std::string& topic) const {
    for (const auto& [frame, is_known] : is_known_) {
      if (is_known) continue;
      throw std::runtime_error(fmt::format(
          "topic '{}': the bag has no transform from the frame '{}' to '{}' at the time of any "
          "message",
          topic, frame, wanted_));
    }
  }

 private:
  const rosbag::Bag& bag_;
  std::string wanted_;
  std::optional<BagTransforms> transforms_;
  std::map<std::string, bool> is_known_;
};

BagTracks readTopic(const rosbag::Bag& bag, const BagSource& source,
                    const std::function<void(size_t, size_t)>& progress) {
  const std::string topic = withoutSlash(source.topic);
  const std::vector<Sweep> sweeps = readSweeps(bag, topic, progress);
  FrameFinder frames(bag, withoutSlash(source.frame));
  std::map<std::pair<double, std::int64_t>, Point> places;  // by time and person
  BagTracks tracks;
  tracks.messages = sweeps.size();
  for (const Sweep& sweep : sweeps) {
    const std::optional<Pose> frame = frames.find(sweep);
    if (!frame) ++tracks.left_out;
    if (!frame) continue;
    for (const Track& track : sweep.people.tracks) {
      places[{sweep.people.stamp, track.id}] = transformed(*frame, track.position);
    }
  }
  frames.throwIfUnknown(topic);
  if (places.empty()) throw std::runtime_error(fmt::format("topic '{}': no tracks", topic));
  for (const auto& [key, position] : places) {
    tracks.samples.push_back({key.first, key.second, position});
  }
  return tracks;
}

}  // namespace

BagTracks readTracksBag(const BagSource& source,
                        const std::function<void(size_t, size_t)>& progress) {
  std::ifstream file(source.path);
  file.peek();  // fails on a directory
  if (!file.is_open() || file.bad()) throw std::runtime_error(cannotBeRead(source.path));
  try {
    const rosbag::Bag bag(source.path);
    return readTopic(bag, source, progress);
  } catch (const std::exception& error) {
    throw std::runtime_error(fmt::format("{}: {}", source.path, error.what()));
  }
}

}  // namespace pomdp_crowd_nav
