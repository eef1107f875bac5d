// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <optional>
#include <string>

#include "pomdp_crowd_nav/ros/command_loop.h"

namespace pomdp_crowd_nav {

// Time runs by hand; the base does what it is told.
class CommandLoopTest : public testing::Test {
 protected:
  static PlannerNodeParams params() {
    PlannerNodeParams params;
    VehicleParams& vehicle = params.navigation.planning.model.vehicle;
    vehicle.max_speed = 1.0;
    vehicle.radius = 0.5;
    vehicle.instant_velocity = false;
    params.navigation.planning.model.step = 0.5;
    params.navigation.planning.model.goal_tolerance = 0.5;
    params.navigation.emergency.reflex_distance = 1.0;
    return params;
  }

  explicit CommandLoopTest(const PlannerNodeParams& p = params())
      : loop_(p),
        drive_(MotionExecutor(p.navigation.command, p.navigation.planning.model.vehicle, 0.05)) {
    StaticMap::Obstacles none;
    drive_.inputs.map = std::make_shared<const StaticMap>(Bounds(), none);
    drive_.inputs.map_at = now_;
    drive_.inputs.robot = RobotReading();
    drive_.inputs.first_tracks_at = now_ - 10.0;
    drive_.goal = Goal{1, Pose{Point(20.0, 0.0), 2.0}};
    drive_.prepared = true;
    drive_.counts.decisions = 1;
    refreshInputs();
  }

  void refreshInputs() {
    drive_.inputs.robot->measured_at = now_;
    drive_.inputs.tracks_at = now_;
  }

  // Ticks for a while; the inputs stay fresh unless they are silent.
  CommandLoop::Tick run(double duration) {
    CommandLoop::Tick last;
    for (const double end = now_ + duration; now_ < end - 1e-9;) {
      now_ += 0.05;
      if (!is_silent_) refreshInputs();
      last = loop_.tick(now_, drive_);
      if (last.command) obey(*last.command);
      if (last.finished) finished_ = last.finished;
    }
    return last;
  }

  void obey(const BaseCommand& command) {
    RobotReading& robot = *drive_.inputs.robot;
    robot.velocity = rotated(robot.pose.heading, command.velocity);
    robot.yaw_rate = command.yaw_rate;
    robot.pose.position += 0.05 * robot.velocity;
    robot.pose.heading = wrapAngle(robot.pose.heading + 0.05 * command.yaw_rate);
  }

  void cruise() {
    StepMotion motion;
    motion.start_velocity = motion.end_velocity = Point(0.8, 0.0);
    motion.duration = 60.0;
    motion.instant = false;
    drive_.executor.follow(motion, now_);
    run(1.0);
  }

  void expectEnd(Outcome outcome, const std::string& text) const {
    ASSERT_TRUE(finished_);
    EXPECT_EQ(finished_->outcome, outcome);
    EXPECT_EQ(finished_->text, text);
  }

  double speed() const { return drive_.inputs.robot->velocity.norm(); }

  double now_ = 100.0;  // [s]
  bool is_silent_ = false;
  CommandLoop loop_;
  Drive drive_;
  std::optional<Ending> finished_;
};

}  // namespace pomdp_crowd_nav
