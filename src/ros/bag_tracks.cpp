// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/ros/bag_tracks.h"

#include <fmt/format.h>
#include <rosbag/bag.h>
#include <rosbag/view.h>

#include <fstream>
#include <map>
#include <stdexcept>
#include <utility>

#include "pomdp_crowd_nav/params/file_errors.h"
#include "pomdp_crowd_nav/ros/conversions.h"

namespace pomdp_crowd_nav {
namespace {

std::string withoutSlash(const std::string& name) {
  return !name.empty() && name.front() == '/' ? name.substr(1) : name;
}

std::vector<TrackSample> readTopic(const rosbag::Bag& bag, const BagSource& source,
                                   const std::function<void(size_t, size_t)>& progress) {
  const std::string topic = withoutSlash(source.topic);
  rosbag::View view(bag, [&](const rosbag::ConnectionInfo* connection) {
    return withoutSlash(connection->topic) == topic;
  });
  std::map<std::pair<double, std::int64_t>, Point> places;  // by time and person
  size_t read = 0;
  for (const rosbag::MessageInstance& instance : view) {
    const auto persons = instance.instantiate<TrackedPersons>();
    if (!persons) {
      throw std::runtime_error(fmt::format("topic '{}': expected TrackedPersons, got {}", topic,
                                           instance.getDataType()));
    }
    const std::string frame = withoutSlash(persons->header.frame_id);
    if (frame != withoutSlash(source.frame)) {
      throw std::runtime_error(
          fmt::format("topic '{}': expected the frame '{}', got '{}'", topic, source.frame, frame));
    }
    const TrackList list = toTracks(*persons, Pose{});
    for (const Track& track : list.tracks) places[{list.stamp, track.id}] = track.position;
    progress(++read, view.size());
  }
  if (read == 0) throw std::runtime_error(fmt::format("there is no topic '{}'", topic));
  if (places.empty()) throw std::runtime_error(fmt::format("topic '{}': no tracks", topic));
  std::vector<TrackSample> samples;
  for (const auto& [key, position] : places) samples.push_back({key.first, key.second, position});
  return samples;
}

}  // namespace

std::vector<TrackSample> readTracksBag(const BagSource& source,
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
