// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/ros/conversions.h"

#include <algorithm>
#include <cmath>

#include "pomdp_crowd_nav/params/number_text.h"

namespace pomdp_crowd_nav {
namespace {

constexpr std::uint64_t kIdMask = 0x7fffffffffffffffULL;  // ids are not negative

// A denormal number is nothing that a sensor measures; it only makes arithmetic slow.
double flushed(double value) { return std::fpclassify(value) == FP_SUBNORMAL ? 0.0 : value; }

Point toPoint(const geometry_msgs::Point& p) { return {flushed(p.x), flushed(p.y)}; }
Point toPoint(const geometry_msgs::Vector3& v) { return {flushed(v.x), flushed(v.y)}; }

// Yaw of a rotation; none when the quaternion is far from unit length.
std::optional<double> toYaw(const geometry_msgs::Quaternion& q) {
  const double norm = q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w;
  if (!std::isfinite(norm) || std::abs(norm - 1.0) > 0.1) return std::nullopt;
  return std::atan2(2.0 * (q.w * q.z + q.x * q.y), 1.0 - 2.0 * (q.y * q.y + q.z * q.z));
}

std::optional<Pose> toPose(const Point& position, const geometry_msgs::Quaternion& orientation) {
  const std::optional<double> yaw = toYaw(orientation);
  if (!yaw || !position.allFinite()) return std::nullopt;
  return Pose{position, *yaw};
}

// `local` is in the frame.
void addTrack(const Track& local, const Pose& frame, TrackList& list) {
  Track track;
  track.id = local.id;
  track.position = transformed(frame, local.position);
  track.velocity = rotated(frame.heading, local.velocity);
  if (!track.position.allFinite()) return;
  if (!track.velocity.allFinite()) track.velocity = Point(0.0, 0.0);
  list.tracks.push_back(track);
}

geometry_msgs::Quaternion toQuaternion(double yaw) {
  geometry_msgs::Quaternion q;
  q.z = std::sin(0.5 * yaw);
  q.w = std::cos(0.5 * yaw);
  return q;
}

geometry_msgs::Vector3 toVector(const Point& point) {
  geometry_msgs::Vector3 vector;
  vector.x = point.x();
  vector.y = point.y();
  return vector;
}

}  // namespace

Point rotated(double angle, const Point& vector) {
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  return {c * vector.x() - s * vector.y(), s * vector.x() + c * vector.y()};
}

Point transformed(const Pose& frame, const Point& local) {
  return frame.position + rotated(frame.heading, local);
}

Pose transformed(const Pose& frame, const Pose& local) {
  return {transformed(frame, local.position), wrapAngle(frame.heading + local.heading)};
}

Pose inverse(const Pose& frame) {
  return {rotated(-frame.heading, -frame.position), wrapAngle(-frame.heading)};
}

std::optional<Pose> toPose(const geometry_msgs::Pose& pose) {
  return toPose(toPoint(pose.position), pose.orientation);
}

std::optional<Pose> toPose(const geometry_msgs::Transform& transform) {
  return toPose(toPoint(transform.translation), transform.rotation);
}

std::optional<BaseCommand> toCommand(const geometry_msgs::Twist& twist) {
  const BaseCommand command{toPoint(twist.linear), flushed(twist.angular.z)};
  if (!command.velocity.allFinite() || !std::isfinite(command.yaw_rate)) return std::nullopt;
  return command;
}

std::optional<RobotReading> toReading(const nav_msgs::Odometry& odometry, const Pose& odom_frame) {
  const std::optional<Pose> pose = toPose(odometry.pose.pose);
  const std::optional<BaseCommand> twist = toCommand(odometry.twist.twist);
  if (!pose || !twist) return std::nullopt;
  RobotReading reading;
  reading.pose = transformed(odom_frame, *pose);
  reading.velocity = rotated(reading.pose.heading, twist->velocity);
  reading.yaw_rate = twist->yaw_rate;
  const bool is_finite = reading.pose.position.allFinite() && reading.velocity.allFinite();
  if (!is_finite) return std::nullopt;  // finite numbers may be too large to be added
  return reading;
}

TrackList toTracks(const TrackedPersons& persons, const Pose& frame) {
  TrackList list;
  list.stamp = persons.header.stamp.toSec();
  for (const TrackedPerson& person : persons.tracks) {
    addTrack({static_cast<std::int64_t>(person.track_id & kIdMask),
              toPoint(person.pose.pose.position), toPoint(person.twist.twist.linear)},
             frame, list);
  }
  return list;
}

TrackList toTracks(const People& people, const Pose& frame) {
  TrackList list;
  list.stamp = people.header.stamp.toSec();
  for (const Person& person : people.people) {
    addTrack({idOfName(person.name), toPoint(person.position), toPoint(person.velocity)}, frame,
             list);
  }
  return list;
}

size_t countPeople(const TrackedPersons& persons) { return persons.tracks.size(); }
size_t countPeople(const People& people) { return people.people.size(); }

std::int64_t idOfName(const std::string& name) {
  if (const auto number = parseInteger(name); number && *number >= 0) return *number;
  std::uint64_t hash = 0xcbf29ce484222325ULL;
  for (const char character : name) {
    hash = (hash ^ static_cast<unsigned char>(character)) * 0x100000001b3ULL;
  }
  constexpr std::uint64_t kNextBit = 1ULL << 62;
  return static_cast<std::int64_t>((hash & kIdMask) | kNextBit);
}

geometry_msgs::Point toMessage(const Point& point, double z) {
  geometry_msgs::Point message;
  message.x = point.x();
  message.y = point.y();
  message.z = z;
  return message;
}

geometry_msgs::Pose toMessage(const Pose& pose) {
  geometry_msgs::Pose message;
  message.position = toMessage(pose.position);
  message.orientation = toQuaternion(pose.heading);
  return message;
}

geometry_msgs::Transform toTransform(const Pose& pose) {
  geometry_msgs::Transform message;
  message.translation = toVector(pose.position);
  message.rotation = toQuaternion(pose.heading);
  return message;
}

geometry_msgs::Twist toMessage(const BaseCommand& command) {
  geometry_msgs::Twist message;
  message.linear = toVector(command.velocity);
  message.angular.z = command.yaw_rate;
  return message;
}

nav_msgs::Path toMessage(const std::vector<Point>& path, const std_msgs::Header& header) {
  nav_msgs::Path message;
  message.header = header;
  for (size_t i = 0; i < path.size(); ++i) {
    const Point& next = path[std::min(i + 1, path.size() - 1)];
    const Point& before = i + 1 < path.size() ? path[i] : path[i == 0 ? 0 : i - 1];
    geometry_msgs::PoseStamped pose;
    pose.header = header;
    pose.pose = toMessage(Pose{path[i], bearing(before, next)});
    message.poses.push_back(pose);
  }
  return message;
}

CrowdBeliefMessage toMessage(const CrowdBelief& crowd, const std::vector<Point>& destinations,
                             const std_msgs::Header& header) {
  CrowdBeliefMessage message;
  message.header = header;
  for (const Point& destination : destinations) {
    message.destinations.push_back(toMessage(destination));
  }
  for (const PersonBelief& person : crowd.people) {
    PersonBeliefMessage belief;
    belief.id = person.id;
    belief.position = toMessage(person.position);
    belief.velocity = toVector(person.velocity);
    belief.probabilities = person.intention.probabilities();
    belief.probability_standing = person.intention.standing();
    belief.probability_elsewhere = person.intention.elsewhere();
    message.people.push_back(belief);
  }
  return message;
}

TrackedPersons toMessage(const TrackList& tracks, const std_msgs::Header& header) {
  TrackedPersons message;
  message.header = header;
  for (const Track& track : tracks.tracks) {
    TrackedPerson person;
    person.track_id = static_cast<std::uint64_t>(track.id);
    person.detection_id = person.track_id;
    person.is_matched = true;
    const bool moves = track.velocity.norm() > 0.0;
    const double heading = moves ? bearing(Point(0.0, 0.0), track.velocity) : 0.0;
    person.pose.pose = toMessage(Pose{track.position, heading});
    person.twist.twist.linear = toVector(track.velocity);
    message.tracks.push_back(person);
  }
  return message;
}

EpisodeMetricsMessage toMessage(const EpisodeMetrics& metrics) {
  EpisodeMetricsMessage message;
  message.travel_time = metrics.travel_time;
  message.path_length = metrics.path_length;
  message.min_moving_distance = metrics.min_moving_distance;
  message.unsafe_steps = static_cast<std::uint32_t>(metrics.unsafe_steps);
  message.unsafe_ticks = static_cast<std::uint32_t>(metrics.unsafe_ticks);
  message.contact_ticks = static_cast<std::uint32_t>(metrics.contact_ticks);
  message.max_speed = metrics.max_speed;
  message.decisions = static_cast<std::uint32_t>(metrics.decisions);
  message.deadline_misses = static_cast<std::uint32_t>(metrics.deadline_misses);
  message.sudden_brakes = static_cast<std::uint32_t>(metrics.sudden_brakes);
  return message;
}

}  // namespace pomdp_crowd_nav
