// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/ros.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <string>

#include "foreign_message.h"
#include "inputs_test.h"

namespace pomdp_crowd_nav {

// A tracker that sees 10 000 people five times a second, until it is interrupted. It is this
// program again, in a process of its own: 35 MB/s through the test's connections would delay what
// it measures.
constexpr const char* kCrowdArgument = "--crowd";

inline int runCrowd() {
  ros::NodeHandle node;
  ros::Publisher publisher = node.advertise<Foreign<TrackedPersons>>("tracked_persons", 1);
  Foreign<TrackedPersons> crowd;
  crowd.message.header.frame_id = "map";
  crowd.message.tracks = bystanders(10000);
  while (ros::ok()) {
    ros::WallDuration(0.2).sleep();
    crowd.message.header.stamp = ros::Time::now();
    publisher.publish(crowd);
  }
  return 0;
}

class CrowdProcess {
 public:
  CrowdProcess() {
    std::string program = "/proc/self/exe", argument = kCrowdArgument, name = "__name:=crowd";
    char* arguments[] = {program.data(), argument.data(), name.data(), nullptr};
    EXPECT_EQ(posix_spawn(&pid_, program.c_str(), nullptr, nullptr, arguments, environ), 0);
  }
  ~CrowdProcess() {
    kill(pid_, SIGINT);
    waitpid(pid_, nullptr, 0);
  }

 private:
  pid_t pid_ = 0;
};

}  // namespace pomdp_crowd_nav
