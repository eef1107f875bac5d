// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "pomdp_crowd_nav/control/command_generator.h"
#include "pomdp_crowd_nav/ros/conversions.h"

namespace pomdp_crowd_nav {

// The motion that the base is following, and where that takes it. All times [s], steady clock.
class MotionExecutor {
 public:
  static constexpr double kRestSpeed = 0.05;  // [m/s], slower counts as at rest

  // `period` [s] between two commands.
  MotionExecutor(const CommandGenerator::Params& params, const VehicleParams& vehicle,
                 double period);

  // Takes over from the present motion at `start_time`.
  void follow(const StepMotion& motion, double start_time);

  // Brakes to rest from now on; counts up `stopCount`.
  void stop();
  long stopCount() const { return stop_count_; }

  // True while there is no motion to follow: the base brakes or is at rest.
  bool isStopping(double now) const { return !next_ && generator_.isStopping(now); }

  BaseCommand commandAt(double now, const RobotReading& reading);

  // Where the base will be: the reading moved on along what is left of the motion.
  VehicleState predict(const RobotReading& reading, double time) const;

 private:
  struct Motion {
    StepMotion path;
    double start = 0.0;
    double end(double hold) const { return start + path.duration + hold; }
    Point displacementAt(double time) const;
    double headingAt(double time) const;
  };

  static double travelHeading(const RobotReading& reading, const std::optional<Motion>& last);
  VehicleState braked(const VehicleState& from, double duration) const;

  CommandGenerator::Params params_;
  VehicleParams vehicle_;
  double period_;
  CommandGenerator generator_;
  std::optional<Motion> current_;
  std::optional<Motion> next_;
  long stop_count_ = 0;
};

}  // namespace pomdp_crowd_nav
