// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <geometry_msgs/PoseStamped.h>
#include <geometry_msgs/Transform.h>
#include <geometry_msgs/Twist.h>
#include <nav_msgs/Odometry.h>
#include <nav_msgs/Path.h>

#include <optional>
#include <string>
#include <vector>

#include "pomdp_crowd_nav/belief/belief_tracker.h"
#include "pomdp_crowd_nav/evaluation/metrics.h"
#include "pomdp_crowd_nav/ros/messages.h"
#include "pomdp_crowd_nav/world/base_command.h"
#include "pomdp_crowd_nav/world/track.h"

namespace pomdp_crowd_nav {

// A measured state of the base, in the planning frame.
struct RobotReading {
  double measured_at = 0.0;  // [s], steady clock
  Pose pose;                 // heading: of the body
  Point velocity{0.0, 0.0};  // [m/s]
  double yaw_rate = 0.0;     // [rad/s]
};

// A frame's pose in another frame is the transform from the one to the other.
Pose transformed(const Pose& frame, const Pose& local);
Point transformed(const Pose& frame, const Point& local);
Point rotated(double angle, const Point& vector);
Pose inverse(const Pose& frame);

// From messages. Nothing is returned when a number is not finite or an orientation no rotation.
std::optional<Pose> toPose(const geometry_msgs::Pose& pose);
std::optional<Pose> toPose(const geometry_msgs::Transform& transform);
std::optional<BaseCommand> toCommand(const geometry_msgs::Twist& twist);
std::optional<RobotReading> toReading(const nav_msgs::Odometry& odometry, const Pose& odom_frame);

// People without a finite position are left out; a velocity that is not finite counts as zero.
TrackList toTracks(const TrackedPersons& persons, const Pose& frame);
TrackList toTracks(const People& people, const Pose& frame);

// How many people the message names, readable or not.
size_t countPeople(const TrackedPersons& persons);
size_t countPeople(const People& people);

// Id of the person of that name: a name of decimal digits is its own number; any other becomes
// its FNV-1a hash of 64 bits with the highest bit cleared and the next one set, so that it is the
// same everywhere and far from small numbers. Never negative.
std::int64_t idOfName(const std::string& name);

// To messages.
geometry_msgs::Point toMessage(const Point& point, double z = 0.0);
geometry_msgs::Pose toMessage(const Pose& pose);
geometry_msgs::Transform toTransform(const Pose& pose);
geometry_msgs::Twist toMessage(const BaseCommand& command);
nav_msgs::Path toMessage(const std::vector<Point>& path, const std_msgs::Header& header);
CrowdBeliefMessage toMessage(const CrowdBelief& crowd, const std::vector<Point>& destinations,
                             const std_msgs::Header& header);
TrackedPersons toMessage(const TrackList& tracks, const std_msgs::Header& header);
EpisodeMetricsMessage toMessage(const EpisodeMetrics& metrics);

}  // namespace pomdp_crowd_nav
