// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/ros/motion_executor.h"

#include <algorithm>
#include <cmath>

namespace pomdp_crowd_nav {

MotionExecutor::MotionExecutor(const CommandGenerator::Params& params, const VehicleParams& vehicle,
                               double period)
    : params_(params), vehicle_(vehicle), period_(period), generator_(params, vehicle) {}

void MotionExecutor::follow(const StepMotion& motion, double start_time) {
  next_ = Motion{motion, start_time};
}

void MotionExecutor::stop() {
  current_.reset();
  next_.reset();
  generator_.stop();
  ++stop_count_;
}

BaseCommand MotionExecutor::commandAt(double now, const RobotReading& reading) {
  // A command holds until the next one: of all ticks, take the one nearest to the start.
  if (next_ && now + 0.5 * period_ >= next_->start) {
    current_ = next_;
    next_.reset();
    generator_.follow(current_->path, current_->start);
  }
  return generator_.commandAt(now, reading.pose.heading, reading.velocity);
}

// From the start of the motion; before it the base moved at the velocity that the motion starts
// with.
Point MotionExecutor::Motion::displacementAt(double time) const {
  if (time < start) return (time - start) * path.start_velocity;
  return path.positionAt(time - start) - path.start;
}

double MotionExecutor::Motion::headingAt(double time) const {
  return path.headingAt(std::max(0.0, time - start));
}

// Of a base without a motion to follow, which faces wherever it likes.
double MotionExecutor::travelHeading(const RobotReading& reading,
                                     const std::optional<Motion>& last) {
  if (reading.velocity.norm() > kRestSpeed) {
    return std::atan2(reading.velocity.y(), reading.velocity.x());
  }
  return last ? last->path.end_heading : reading.pose.heading;
}

VehicleState MotionExecutor::predict(const RobotReading& reading, double time) const {
  const double speed = reading.velocity.norm();
  const bool is_car = vehicle_.kind == VehicleKind::kCar;
  VehicleState state{reading.pose.position, reading.pose.heading, 0.0};
  const std::optional<Motion>& motion = next_ ? next_ : current_;
  if (!motion || motion->end(params_.hold_time) <= reading.measured_at) {
    if (speed > kRestSpeed) state.speed = speed;
    if (!is_car) state.heading = travelHeading(reading, motion);
    return braked(state, time - reading.measured_at);
  }
  const double until = std::min(time, motion->end(params_.hold_time));
  state.position += motion->displacementAt(until) - motion->displacementAt(reading.measured_at);
  const double heading = motion->headingAt(until);
  // A car faces where it drives, whether or not that is where it should.
  const double turn = heading - motion->headingAt(reading.measured_at);
  state.heading = is_car ? wrapAngle(reading.pose.heading + turn) : heading;
  state.speed = motion->path.velocityAt(until - motion->start).norm();
  if (state.speed <= kRestSpeed) state.speed = 0.0;
  return braked(state, time - until);
}

VehicleState MotionExecutor::braked(const VehicleState& from, double duration) const {
  if (duration <= 0.0 || from.speed <= 0.0) return from;
  VehicleState state = from;
  state.speed = speedAfterBrake(vehicle_, from.speed, duration);
  state.position +=
      (stoppingDistance(vehicle_, from.speed) - stoppingDistance(vehicle_, state.speed)) *
      unitVector(from.heading);
  if (state.speed <= kRestSpeed) state.speed = 0.0;
  return state;
}

}  // namespace pomdp_crowd_nav
