// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <geometry_msgs/Twist.h>
#include <ros/ros.h>
#include <rosgraph_msgs/Clock.h>
#include <tf2_ros/transform_broadcaster.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <limits>
#include <mutex>
#include <thread>

#include "foreign_message.h"
#include "pomdp_crowd_nav/ros/conversions.h"
#include "pomdp_crowd_nav/sim/base.h"

namespace pomdp_crowd_nav {

// What is around a velocity guard: a planner that commands whatever it is told to, a base with
// limits and a watchdog, its localisation, a people tracker that sees at most one person, of
// spencer_tracking_msgs or of people_msgs, and the clock. Each of them can be made to fail.
class GuardedRobot {
 public:
  std::atomic<bool> is_planner_silent{true};
  std::atomic<bool> is_odometry_silent{false};
  std::atomic<bool> is_odometry_nan{false};
  std::atomic<bool> are_people_silent{false};
  std::atomic<bool> is_tracker_of_people_msgs{false};  // which then is the only one
  std::atomic<bool> is_transform_silent{false};
  std::atomic<bool> has_watchdog{true};
  std::atomic<bool> are_stamps_absurd{false};  // the last that a message can have, in 2106
  std::atomic<double> stamps_ahead{0.0};       // [s], on odometry and people
  std::atomic<double> clock_offset{1000.0};    // [s]

  explicit GuardedRobot(const VehicleParams& vehicle) : base_(vehicle, Pose{}) {
    clock_ = node_.advertise<rosgraph_msgs::Clock>("/clock", 1);
    planner_ = node_.advertise<geometry_msgs::Twist>("cmd_vel_raw", 1);
    odometry_ = node_.advertise<nav_msgs::Odometry>("odom", 1);
    persons_ = node_.advertise<TrackedPersons>("tracked_persons", 1);
    people_ = node_.advertise<Foreign<People>>("people", 1);
    commands_ = node_.subscribe("cmd_vel", 1, &GuardedRobot::onCommand, this,
                                ros::TransportHints().tcpNoDelay());
    thread_ = std::thread([this] { run(); });
  }

  ~GuardedRobot() {
    stop_ = true;
    thread_.join();
  }

  // From now on, 20 times a second.
  void command(double x, double y, double yaw_rate) {
    const std::lock_guard<std::mutex> lock(mutex_);
    command_.linear.x = x;
    command_.linear.y = y;
    command_.angular.z = yaw_rate;
    is_planner_silent = false;
  }

  // Stands at `place` [m], in the frame map.
  void putPerson(const Point& place) {
    const std::lock_guard<std::mutex> lock(mutex_);
    person_ = place;
    nearest_ = std::numeric_limits<double>::infinity();
  }

  double speed() const { return speed_; }  // [m/s], what the base really drives
  bool isAtRest() const { return speed_ < 0.01; }
  double topCommand() const { return top_command_; }  // [m/s]
  double topYawRate() const { return top_yaw_rate_; }
  bool areCommandsFinite() const { return are_commands_finite_; }
  int commandCount() const { return command_count_; }

  Point position() {  // [m], in the frame map
    const std::lock_guard<std::mutex> lock(mutex_);
    return transformed(kOdomInMap, base_.pose().position);
  }
  // A place in front of the robot.
  Point ahead(double distance, double aside = 0.0) {
    const std::lock_guard<std::mutex> lock(mutex_);
    return transformed(transformed(kOdomInMap, base_.pose()), Point(distance, aside));
  }
  double nearest() {  // [m] to the person since it was put there
    const std::lock_guard<std::mutex> lock(mutex_);
    return nearest_;
  }

 private:
  static constexpr double kPeriod = 0.02;   // [s]
  static constexpr double kWatchdog = 0.5;  // [s]
  const Pose kOdomInMap{Point(10.0, 10.0), 0.5};

  void onCommand(const geometry_msgs::Twist& twist) {
    const auto command = pomdp_crowd_nav::toCommand(twist);
    are_commands_finite_ = are_commands_finite_ && command.has_value();
    if (!command) return;
    const std::lock_guard<std::mutex> lock(mutex_);
    received_ = *command;
    received_at_ = time_;
    top_command_ = std::max(top_command_.load(), command->velocity.norm());
    top_yaw_rate_ = std::max(top_yaw_rate_.load(), std::abs(command->yaw_rate));
    ++command_count_;
  }

  void run() {
    auto next = std::chrono::steady_clock::now();
    for (int i = 0; !stop_; ++i) {
      move();
      stamp_ = ros::Time(clock_offset + time_);
      rosgraph_msgs::Clock clock;
      clock.clock = stamp_;
      clock_.publish(clock);
      if (are_stamps_absurd)
        stamp_ = ros::Time(std::numeric_limits<std::uint32_t>::max(), 999999999);
      if (!is_transform_silent) publishTransform();
      if (!is_odometry_silent) publishOdometry();
      if (!are_people_silent && i % 5 == 0) publishPeople();
      if (!is_planner_silent && i % 5 % 2 == 0) publishCommand();  // 30 Hz, unevenly
      next += std::chrono::milliseconds(20);
      std::this_thread::sleep_until(next);
    }
  }

  void move() {
    const std::lock_guard<std::mutex> lock(mutex_);
    time_ += kPeriod;
    const bool is_obeyed = !has_watchdog || time_ - received_at_ <= kWatchdog;
    base_.follow(is_obeyed ? received_ : BaseCommand(), kPeriod);
    speed_ = base_.velocity().norm();
    const Point here = transformed(kOdomInMap, base_.pose().position);
    if (person_.allFinite()) nearest_ = std::min(nearest_, (person_ - here).norm());
  }

  void publishTransform() {
    geometry_msgs::TransformStamped transform;
    transform.header.frame_id = "map";
    transform.header.stamp = stamp_;
    transform.child_frame_id = "odom";
    transform.transform = toTransform(kOdomInMap);
    transforms_.sendTransform(transform);
  }

  void publishOdometry() {
    const std::lock_guard<std::mutex> lock(mutex_);
    nav_msgs::Odometry odometry;
    odometry.header.frame_id = "odom";
    odometry.header.stamp = stamp_ + ros::Duration(stamps_ahead);
    odometry.child_frame_id = "base_link";
    odometry.pose.pose = toMessage(base_.pose());
    const Point velocity = rotated(-base_.pose().heading, base_.velocity());
    odometry.twist.twist = toMessage(BaseCommand{velocity, base_.yawRate()});
    if (is_odometry_nan) odometry.twist.twist.linear.x = std::nan("");
    odometry_.publish(odometry);
  }

  void publishPeople() {
    const std::lock_guard<std::mutex> lock(mutex_);
    TrackList tracks;
    if (person_.allFinite()) tracks.tracks = {{7, person_, Point(0.0, 0.0)}};
    std_msgs::Header header;
    header.frame_id = "map";
    header.stamp = stamp_ + ros::Duration(stamps_ahead);
    if (!is_tracker_of_people_msgs) return persons_.publish(toMessage(tracks, header));
    Foreign<People> people;
    people.message.header = header;
    for (const Track& track : tracks.tracks) {
      Person person;
      person.name = std::to_string(track.id);
      person.position = toMessage(track.position);
      people.message.people.push_back(person);
    }
    people_.publish(people);
  }

  void publishCommand() {
    const std::lock_guard<std::mutex> lock(mutex_);
    planner_.publish(command_);
  }

  ros::NodeHandle node_;
  ros::Publisher clock_, planner_, odometry_, persons_, people_;
  ros::Subscriber commands_;
  tf2_ros::TransformBroadcaster transforms_;

  std::mutex mutex_;  // of what follows, up to the atomics
  SimulatedBase base_;
  geometry_msgs::Twist command_;
  Point person_{std::nan(""), std::nan("")};
  BaseCommand received_;
  double received_at_ = -1.0;  // [s]
  double time_ = 0.0;          // [s]
  double nearest_ = std::numeric_limits<double>::infinity();

  std::atomic<double> speed_{0.0}, top_command_{0.0}, top_yaw_rate_{0.0};
  std::atomic<int> command_count_{0};
  std::atomic<bool> are_commands_finite_{true};
  ros::Time stamp_;  // touched by the thread only
  std::atomic<bool> stop_{false};
  std::thread thread_;
};

}  // namespace pomdp_crowd_nav
