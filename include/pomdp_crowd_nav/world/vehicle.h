// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <optional>
#include <vector>

#include "pomdp_crowd_nav/world/geometry.h"

namespace pomdp_crowd_nav {

enum class VehicleKind {
  kHolonomic,  // drives in any direction; the body turns to follow
  kCar         // drives where it faces, on arcs (Dubins' car, NHV in the paper)
};

// `heading` is the direction of travel; that of a car's body too.
struct VehicleState {
  Point position{0.0, 0.0};  // [m]
  double heading = 0.0;      // [rad]
  double speed = 0.0;        // [m/s], never negative

  Point velocity() const { return speed * unitVector(heading); }
};

// How the velocity of a base may change. The paper's base takes any velocity at once; a real one
// needs time, so its velocity runs linearly from the old to the new value over a step.
struct VehicleParams {
  VehicleKind kind = VehicleKind::kHolonomic;
  double radius = 1.0;                // [m], paper's L
  double max_speed = 2.0;             // [m/s], v_max
  double acceleration = 1.0;          // [m/s^2], one speed step is acceleration * step
  double lateral_acceleration = 1.0;  // [m/s^2], bounds the turn of a moving base
  double brake_deceleration = 1.0;    // [m/s^2], of the sudden brake
  double max_yaw_rate = 1.0;          // [rad/s], of the body
  double yaw_acceleration = 2.0;      // [rad/s^2], of the body
  bool instant_velocity = true;       // true: the limits on acceleration do not hold in a step
  // Of a car, whose rear axle is its position. Steering takes no time.
  double wheelbase = 1.0;               // [m]
  double max_steering_angle = 0.67;     // [rad]
  double max_turn_per_step = M_PI / 4;  // [rad], change of heading in a step, at most pi / 2
};

// Throws std::invalid_argument naming the first field that is out of range.
void validate(const VehicleParams& params);

// Speed after a step in which the base tries to change it by `speed_change` [m/s].
double speedAfter(const VehicleParams& params, double speed, double speed_change);

// Speed after a step of `step` seconds of the sudden brake (SB in the paper).
double speedAfterBrake(const VehicleParams& params, double speed, double step);

// Distance covered from `speed` to rest with the sudden brake [m].
double stoppingDistance(const VehicleParams& params, double speed);

// Largest chord |u' - u| between the unit vectors of travel before and after a step, from
// speed * |u' - u| <= lateral_acceleration * step; 2 (any turn) at rest and for an instant base.
double maxTurnChord(const VehicleParams& params, double speed, double step);

// Direction of travel after turning from `heading` toward `desired` as far as the chord allows.
double turnToward(double heading, double desired, double max_chord);

// Curvature of a car's tightest turn [1/m].
double maxCurvature(const VehicleParams& params);

// The same at a speed [m/s], for which there may be too little yaw rate or lateral acceleration.
double maxCurvature(const VehicleParams& params, double speed);

// Largest change of heading of a car on an arc that takes no longer than a step [rad]; neither of
// the speeds at its ends [m/s] may ask for more yaw rate or lateral acceleration than there is.
double maxArcTurn(const VehicleParams& params, double length, double fastest);

// A piece of a path with one curvature.
struct PathLeg {
  double heading = 0.0;  // [rad], of travel at its beginning
  double turn = 0.0;     // [rad], change of heading over its length
  double length = 0.0;   // [m]

  // From its beginning to `distance` [m] along it.
  Point displacement(double distance) const;
  double headingAt(double distance) const;
};

// A velocity that runs from one value to another over a step, straight or along legs.
struct StepMotion {
  Point start{0.0, 0.0};           // [m]
  Point start_velocity{0.0, 0.0};  // [m/s]
  Point end_velocity{0.0, 0.0};    // [m/s]
  double end_heading = 0.0;        // [rad], of travel; kept when the base stops
  double duration = 1.0;           // [s]
  bool instant = true;             // velocity is end_velocity from the start
  // The way that is driven, if it is not straight: at the speeds of the two velocities, to its end
  // at most within the step, and straight on after the step.
  std::vector<PathLeg> legs;

  Point velocityAt(double time) const;
  Point positionAt(double time) const;
  double headingAt(double time) const;   // [rad], of travel; end_heading where there are no legs
  double distanceAt(double time) const;  // [m] driven by then, where there are legs
  VehicleState end() const;
};

// Motion of a base that ends the step at `speed` in direction `heading`; the turn is clamped to
// what the base can do. A car drives one arc.
StepMotion stepMotion(const VehicleParams& params, const VehicleState& from, double heading,
                      double speed, double step);

// The arc on which a car gets from its pose to a place; nothing unless that lies ahead of it.
std::optional<PathLeg> arcTo(const VehicleState& from, const Point& place);

// The same motion, but on the arc to `place`, where it ends, if that is on the way: no farther than
// the car gets in the step, not too sharp a turn and, of a car on ramps, no more to slow down than
// by `acceleration`.
std::optional<StepMotion> stopAt(const VehicleParams& params, const Point& place,
                                 const VehicleState& from, const StepMotion& motion);

}  // namespace pomdp_crowd_nav
