// SPDX-License-Identifier: BSD-3-Clause
#include <ros/serialization.h>

#include <cmath>
#include <cstring>
#include <optional>

#include "fuzz_file.h"
#include "pomdp_crowd_nav/ros/conversions.h"
#include "pomdp_crowd_nav/ros/map_conversions.h"

namespace pomdp_crowd_nav {
namespace {

using Bytes = std::pair<const std::uint8_t*, std::uint32_t>;

const Pose kFrame{Point(10.0, -3.0), 0.7};

// The number of elements that an array claims after a header and `fixed` bytes. roscpp makes room
// for them before it looks for them, and the transport has limits of its own.
bool claimsTooMuch(const Bytes& bytes, size_t fixed) {
  std::uint32_t frame = 0, count = 0;
  if (bytes.second < 16) return false;
  std::memcpy(&frame, bytes.first + 12, sizeof(frame));
  const size_t begin = size_t{16} + frame + fixed;
  if (begin + sizeof(count) > bytes.second) return false;
  std::memcpy(&count, bytes.first + begin, sizeof(count));
  return count > bytes.second;
}

template <typename Message>
std::optional<Message> deserialized(const Bytes& bytes) {
  ros::serialization::IStream stream(const_cast<std::uint8_t*>(bytes.first), bytes.second);
  Message message;
  try {
    ros::serialization::deserialize(stream, message);
  } catch (const ros::Exception&) {  // roscpp drops it
    return std::nullopt;
  }
  return message;
}

void checkOdometry(const Bytes& bytes) {
  const auto odometry = deserialized<nav_msgs::Odometry>(bytes);
  if (!odometry) return;
  const std::optional<RobotReading> reading = toReading(*odometry, kFrame);
  if (!reading) return;
  promise(reading->pose.position.allFinite() && std::isfinite(reading->pose.heading),
          "finite pose");
  promise(reading->velocity.allFinite() && std::isfinite(reading->yaw_rate), "finite velocity");
}

void checkPersons(const Bytes& bytes) {
  if (claimsTooMuch(bytes, 0)) return;
  const auto persons = deserialized<TrackedPersons>(bytes);
  if (!persons) return;
  const TrackList list = toTracks(*persons, kFrame);
  promise(list.tracks.size() <= persons->tracks.size(), "no more tracks than were sent");
  for (const Track& track : list.tracks) {
    promise(track.position.allFinite() && track.velocity.allFinite(), "finite tracks");
  }
}

void checkGrid(const Bytes& bytes) {
  constexpr size_t kInfo = 8 + 4 + 4 + 4 + 7 * 8;  // bytes of nav_msgs/MapMetaData
  if (claimsTooMuch(bytes, kInfo)) return;
  const auto grid = deserialized<nav_msgs::OccupancyGrid>(bytes);
  if (!grid) return;
  static const StaticMap world(Bounds{Point(0.0, 0.0), Point(4.0, 3.0)}, {});
  isDrawingOf(world, *grid);
  try {
    const auto map = toStaticMap(*grid);
    const Bounds& bounds = map->bounds();
    promise(bounds.min.allFinite() && bounds.max.allFinite(), "finite bounds");
    promise(!std::isnan(map->clearance(0.5 * (bounds.min + bounds.max))), "a clearance");
    promise(!std::isnan(map->clearance(bounds.max + Point(1.0, 1.0))), "a clearance off the map");
  } catch (const std::invalid_argument&) {  // refused with the reason
  }
}

}  // namespace
}  // namespace pomdp_crowd_nav

// The first byte says of which type the message is.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, size_t size) {
  using namespace pomdp_crowd_nav;
  if (size < 1) return 0;
  const Bytes bytes{data + 1, static_cast<std::uint32_t>(size - 1)};
  switch (data[0] % 3) {
    case 0:
      checkOdometry(bytes);
      break;
    case 1:
      checkPersons(bytes);
      break;
    default:
      checkGrid(bytes);
  }
  return 0;
}
