// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "pomdp_crowd_nav/control/emergency_override.h"
#include "pomdp_crowd_nav/control/obstacle_reflex.h"
#include "pomdp_crowd_nav/ros/drive.h"

namespace pomdp_crowd_nav {

// What happens at every tick of the command timer, without ROS: is the goal reached, is an input
// missing, is somebody too close, and which velocity follows from all that.
class CommandLoop {
 public:
  explicit CommandLoop(const PlannerNodeParams& params);

  struct Tick {
    std::optional<BaseCommand> command;  // none while the base is nobody's business
    std::optional<Ending> finished;      // a trip whose base is at rest: report it now
  };

  // `now` [s], steady clock.
  Tick tick(double now, Drive& drive);

  // Of what may change in flight.
  void setParams(const NavigationParams& params);

  const InputLimits& limits() const { return limits_; }

 private:
  void watchInputs(double now, Drive& drive) const;
  void watchPeople(double now, Drive& drive) const;
  void watchMap(double now, Drive& drive) const;
  void watchProgress(double now, Drive& drive) const;
  std::string whyNotReached(double now, const Drive& drive, bool at_rest) const;
  void finish(double now, Drive& drive, bool at_rest, Tick& tick) const;
  bool isPastGoal(const Drive& drive) const;
  bool hasReachedGoal(const Drive& drive) const;
  bool isFresh(double now, const Drive& drive) const;
  bool isAtRest(double now, const Drive& drive);
  bool isOver(double now, const Drive& drive, bool at_rest) const;
  double yawError(const Drive& drive) const;
  BaseCommand turnInPlace(double yaw_error);

  InputLimits limits_;
  double goal_tolerance_;    // [m]
  double yaw_tolerance_;     // [rad]
  double yaw_gain_;          // [1/s]
  double stopped_speed_;     // [m/s]
  double stopped_yaw_rate_;  // [rad/s]
  double period_;            // [s]
  VehicleParams vehicle_;
  EmergencyOverride emergency_;
  ObstacleReflex obstacles_;
  bool resting_ = true;  // the base has been at rest since the last trip
  double rest_since_ = -1.0;
  double last_yaw_rate_ = 0.0;
};

// Begins the trip, without a stop where the robot is driving already; one that was still turning at
// its goal or braking is over. False, and nothing changed, when a newer trip has begun or the node
// ends.
bool beginTrip(const Goal& goal, double now, Drive& drive);

// Ends the trip: from now on the base is stopped. Does nothing without a goal.
void endTrip(Outcome outcome, const std::string& text, double now, Drive& drive);

// Ends the trip before the goal, or the turn at it. Does nothing without either.
void cancelTrip(double now, Drive& drive);

// The same for the trip to the goal of that number; nothing to any other, so that a cancel that
// comes late ends no newer one.
void cancelTrip(long number, double now, Drive& drive);

}  // namespace pomdp_crowd_nav
