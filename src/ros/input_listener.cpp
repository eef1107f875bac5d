// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/ros/input_listener.h"

#include <ros/console.h>

#include <algorithm>
#include <stdexcept>
#include <thread>

#include "pomdp_crowd_nav/ros/map_conversions.h"
#include "pomdp_crowd_nav/ros/steady_time.h"

namespace pomdp_crowd_nav {
namespace {

constexpr double kTransformWait = 0.05;  // [s], longest wait for a transform
constexpr double kClockSlack = 0.1;      // [s], a system clock may be set back this much
constexpr int kQueue = 1;                // only the newest message counts

// Moment on the steady clock at which a message was measured; a stamp of the future is now.
double measuredAt(const ros::Time& stamp, const ros::Time& now) {
  return steadySeconds() - std::max(0.0, (now - stamp).toSec());
}

}  // namespace

InputListener::InputListener(ros::NodeHandle& node, const PlannerNodeParams& params,
                             Guarded<Drive>& drive)
    : global_frame_(params.frames.global),
      tolerance_(params.navigation.transform_tolerance),
      max_speed_(params.navigation.planning.model.vehicle.max_speed),
      drive_(drive),
      transforms_(buffer_),
      tracker_(params.destinations, params.navigation.belief),
      map_policy_(params.map) {
  odometry_ = node.subscribe("odom", kQueue, &InputListener::onOdometry, this,
                             ros::TransportHints().tcpNoDelay());
  persons_ = node.subscribe("tracked_persons", kQueue, &InputListener::onPersons, this,
                            ros::TransportHints().tcpNoDelay());
  if (!params.world_file.empty()) {
    world_map_ = std::make_shared<const StaticMap>(loadWorld(params.world_file).map());
    useMap(world_map_);
  }
  map_ = node.subscribe("map", kQueue, &InputListener::onMap, this);
}

void InputListener::onOdometry(const nav_msgs::Odometry& odometry) {
  const ros::Time now = ros::Time::now();
  noticeClockJump(now);
  const double measured_at = measuredAt(odometry.header.stamp, now);
  const std::optional<Pose> frame = frameAt(odometry.header.frame_id, odometry.header.stamp);
  if (!frame) return countTransformFailure(odometry.header.frame_id);
  std::optional<RobotReading> reading = toReading(odometry, *frame);
  if (reading) reading->measured_at = measured_at;
  if (reading) noticePoseJump(*reading);
  drive_.with([&](Drive& drive) {
    if (reading) {
      drive.inputs.robot = reading;
      return;
    }
    ++drive.inputs.bad_odometry;
    drive.inputs.bad_odometry_at = steadySeconds();
  });
  if (!reading) ROS_WARN_THROTTLE(1.0, "odometry with a number that is not finite is ignored");
}

void InputListener::onPersons(const TrackedPersons& persons) {
  const ros::Time now = ros::Time::now();
  noticeClockJump(now);
  const double measured_at = measuredAt(persons.header.stamp, now);
  const std::optional<Pose> frame = frameAt(persons.header.frame_id, persons.header.stamp);
  if (!frame) return countTransformFailure(persons.header.frame_id);
  drive_.with([&](Drive& drive) {
    Inputs& inputs = drive.inputs;
    constexpr double kGap = 1.0;  // [s], a longer silence breaks the series
    const bool continues = inputs.tracks_at >= 0.0 && measured_at - inputs.tracks_at < kGap;
    if (!continues) inputs.first_tracks_at = measured_at;
    inputs.tracks_at = measured_at;
    tracker_.update(toTracks(persons, *frame));
    inputs.crowd = tracker_.belief();
    inputs.tracks = tracksOf(inputs.crowd);
  });
}

void InputListener::onMap(const nav_msgs::OccupancyGrid& grid) {
  const bool same = grid.info.origin == last_grid_.info.origin && grid.data == last_grid_.data &&
                    grid.info.resolution == last_grid_.info.resolution &&
                    grid.info.width == last_grid_.info.width;
  if (grid.header.frame_id != global_frame_) {
    ROS_ERROR("map: its frame must be '%s', got '%s'", global_frame_.c_str(),
              grid.header.frame_id.c_str());
    return;
  }
  if (same) return drive_.with([](Drive& drive) { drive.inputs.map_at = steadySeconds(); });
  try {
    const bool is_world = world_map_ && isDrawingOf(*world_map_, grid, map_policy_);
    if (world_map_ && !is_world) ROS_INFO("the map on the topic is used, not the world file's");
    useMap(is_world ? world_map_ : toStaticMap(grid, map_policy_));
    last_grid_ = grid;
  } catch (const std::invalid_argument& error) {
    ROS_ERROR("%s", error.what());
  }
}

void InputListener::useMap(std::shared_ptr<const StaticMap> map) {
  drive_.with([&](Drive& drive) {
    drive.inputs.map = std::move(map);
    drive.inputs.map_at = steadySeconds();
  });
}

std::optional<Pose> InputListener::frameAt(const std::string& frame, const ros::Time& stamp) {
  const double give_up = steadySeconds() + kTransformWait;
  while (true) {
    if (const std::optional<Pose> pose = lookUp(frame, stamp)) return pose;
    if (steadySeconds() >= give_up) break;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  try {
    const auto newest = buffer_.lookupTransform(global_frame_, frame, ros::Time(0));
    if (stamp - newest.header.stamp > tolerance_) return std::nullopt;
    return toPose(newest.transform);
  } catch (const tf2::TransformException&) {
    return std::nullopt;
  }
}

std::optional<Pose> InputListener::lookUp(const std::string& frame, const ros::Time& stamp) const {
  if (frame == global_frame_) return Pose{};
  try {
    std::string error;
    if (!buffer_.canTransform(global_frame_, frame, stamp, &error)) return std::nullopt;
    return toPose(buffer_.lookupTransform(global_frame_, frame, stamp).transform);
  } catch (const tf2::TransformException&) {
    return std::nullopt;
  }
}

void InputListener::countTransformFailure(const std::string& frame) {
  drive_.with([](Drive& drive) {
    ++drive.inputs.transform_failures;
    drive.inputs.transform_failure_at = steadySeconds();
  });
  ROS_WARN_THROTTLE(1.0, "no transform from '%s' to '%s'", frame.c_str(), global_frame_.c_str());
}

void InputListener::noticeClockJump(const ros::Time& now) {
  const bool jumped = drive_.with([&](Drive&) {
    const bool back = now + ros::Duration(kClockSlack) < last_time_;
    last_time_ = back ? now : std::max(last_time_, now);
    return back;
  });
  if (!jumped) return;
  ROS_WARN("the clock jumped back: beliefs are forgotten and the base is stopped");
  buffer_.clear();
  forgetEverything();
}

void InputListener::noticePoseJump(const RobotReading& reading) {
  const bool jumped = drive_.with([&](Drive& drive) {
    const std::optional<RobotReading>& last = drive.inputs.robot;
    return last && isPoseJump(*last, reading, max_speed_);
  });
  if (!jumped) return;
  ROS_WARN("the robot's pose jumped: beliefs are forgotten and the base is stopped");
  forgetEverything();
}

void InputListener::forgetEverything() {
  drive_.with([&](Drive& drive) {
    drive.inputs.robot.reset();
    drive.inputs.tracks = TrackList();
    drive.inputs.crowd = CrowdBelief();
    drive.inputs.tracks_at = -1.0;
    drive.inputs.first_tracks_at = -1.0;
    drive.inputs.jump_at = steadySeconds();
    tracker_.clear();
    drive.executor.stop();
  });
}

}  // namespace pomdp_crowd_nav
