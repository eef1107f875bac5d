// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nav_msgs/OccupancyGrid.h>
#include <rosgraph_msgs/Clock.h>
#include <tf2_ros/transform_broadcaster.h>

#include <atomic>
#include <chrono>
#include <functional>
#include <limits>
#include <mutex>
#include <thread>

#include "foreign_message.h"
#include "navigation_client.h"

namespace pomdp_crowd_nav {

// What is done to every message of a topic before it is sent; another thread may change it.
template <class Message>
class Spoiler {
 public:
  void set(std::function<void(Message&)> spoil) {
    const std::lock_guard<std::mutex> lock(mutex_);
    spoil_ = std::move(spoil);
  }

  void apply(Message& message) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (spoil_) spoil_(message);
  }

 private:
  std::mutex mutex_;
  std::function<void(Message&)> spoil_;
};

// A base without limits, its localisation, a people tracker of spencer_tracking_msgs that sees
// nobody, a map server and the clock. Each of them can be made to fail.
class FakeRobot {
 public:
  std::atomic<bool> is_odometry_silent{false};
  std::atomic<bool> is_odometry_nan{false};
  std::atomic<bool> are_people_silent{false};
  std::atomic<bool> is_transform_silent{false};
  std::atomic<bool> is_map_silent{true};
  std::atomic<bool> is_clock_frozen{false};
  std::atomic<bool> is_clock_at_its_end{false};  // as are all stamps
  std::atomic<double> clock_offset{1000.0};      // [s]
  std::atomic<double> x_offset{0.0};             // [m], of the odometry
  Spoiler<nav_msgs::Odometry> odometry_spoiler;
  Spoiler<geometry_msgs::TransformStamped> transform_spoiler;
  Spoiler<TrackedPersons> people_spoiler;

  // The map is sent at 2 Hz unless it is silent.
  explicit FakeRobot(const nav_msgs::OccupancyGrid& map = nav_msgs::OccupancyGrid()) : map_(map) {
    is_map_silent = map.data.empty();
    maps_ = node_.advertise<nav_msgs::OccupancyGrid>("map", 1, true);
    clock_ = node_.advertise<rosgraph_msgs::Clock>("/clock", 1);
    odometry_ = node_.advertise<nav_msgs::Odometry>("odom", 1);
    people_ = node_.advertise<Foreign<TrackedPersons>>("tracked_persons", 1);
    commands_ = node_.subscribe("cmd_vel", 1, &FakeRobot::onCommand, this);
    thread_ = std::thread([this] { run(); });
    people_thread_ = std::thread([this] { runPeople(); });
  }

  // The last time that a message can have, in the year 2106.
  static ros::Time endOfTime() {
    return ros::Time(std::numeric_limits<std::uint32_t>::max(), 999999999);
  }

  // [m/s], of the base itself.
  double speed() const { return std::hypot(x_velocity_, y_velocity_); }

  ~FakeRobot() {
    stop_ = true;
    thread_.join();
    people_thread_.join();
  }

 private:
  static constexpr double kPeriod = 0.02;  // [s]

  void onCommand(const geometry_msgs::Twist& twist) {
    x_velocity_ = twist.linear.x;
    y_velocity_ = twist.linear.y;
    yaw_rate_ = twist.angular.z;
  }

  void run() {
    for (int i = 0; !stop_; ++i) {
      if (!is_clock_frozen) time_ += kPeriod;
      ros_time_ = clock_offset + time_;
      stamp_ = rosTime();
      rosgraph_msgs::Clock clock;
      clock.clock = stamp_;
      clock_.publish(clock);
      move();
      if (!is_transform_silent) publishTransform();
      if (!is_odometry_silent) publishOdometry();
      if (!is_map_silent && i % 25 == 0) maps_.publish(map_);
      std::this_thread::sleep_for(std::chrono::duration<double>(kPeriod));
    }
  }

  // Apart from the rest, as a tracker is: however many people there are, the base is not delayed.
  void runPeople() {
    while (!stop_) {
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
      if (!are_people_silent && ros_time_ > 0.0) publishPeople();
    }
  }

  ros::Time rosTime() const { return is_clock_at_its_end ? endOfTime() : ros::Time(ros_time_); }

  void move() {
    const BaseCommand command{Point(x_velocity_, y_velocity_), yaw_rate_};
    pose_.position += kPeriod * rotated(pose_.heading, command.velocity);
    pose_.heading = wrapAngle(pose_.heading + kPeriod * command.yaw_rate);
  }

  void publishTransform() {
    geometry_msgs::TransformStamped transform;
    transform.header.frame_id = "map";
    transform.header.stamp = stamp_;
    transform.child_frame_id = "odom";
    transform.transform = toTransform(Pose{Point(10.0, 10.0), 0.5});
    transform_spoiler.apply(transform);
    transforms_.sendTransform(transform);
  }

  void publishOdometry() {
    nav_msgs::Odometry odometry;
    odometry.header.frame_id = "odom";
    odometry.header.stamp = stamp_;
    odometry.child_frame_id = "base_link";
    odometry.pose.pose = toMessage(pose_);
    odometry.pose.pose.position.x += x_offset;
    odometry.twist.twist.linear.x = x_velocity_;
    odometry.twist.twist.linear.y = y_velocity_;
    odometry.twist.twist.angular.z = yaw_rate_;
    if (is_odometry_nan) {
      odometry.pose.pose.position.x = std::numeric_limits<double>::quiet_NaN();
    }
    odometry_spoiler.apply(odometry);
    odometry_.publish(odometry);
  }

  void publishPeople() {
    Foreign<TrackedPersons> people;
    people.message.header.frame_id = "map";
    people.message.header.stamp = rosTime();
    people_spoiler.apply(people.message);
    people_.publish(people);
  }

  ros::NodeHandle node_;
  nav_msgs::OccupancyGrid map_;
  ros::Publisher clock_, odometry_, people_, maps_;
  ros::Subscriber commands_;
  tf2_ros::TransformBroadcaster transforms_;
  std::atomic<double> x_velocity_{0.0}, y_velocity_{0.0}, yaw_rate_{0.0};
  double time_ = 0.0;
  std::atomic<double> ros_time_{0.0};  // [s]
  ros::Time stamp_;
  Pose pose_;  // in odom
  std::atomic<bool> stop_{false};
  std::thread thread_, people_thread_;
};

}  // namespace pomdp_crowd_nav
