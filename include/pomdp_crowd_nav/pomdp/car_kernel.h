// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pomdp_crowd_nav/pomdp/step_lanes.h"

// How far a car gets in a step of the model, on one arc; see step_kernel.h.
namespace pomdp_crowd_nav {

// Angle from one direction to another, neither need be of length 1, in [-pi / 2, pi / 2]: larger
// ones are cut off [rad]. To 2e-7.
template <class Value>
PCN_INLINE Value turnAngle(const Value& from_x, const Value& from_y, const Value& to_x,
                           const Value& to_y) {
  const Value dot = from_x * to_x + from_y * to_y;
  const Value cross = from_x * to_y - from_y * to_x;
  const Value size = squareRoot(dot * dot + cross * cross) + larger(dot, spread<Value>(0.0F));
  // Tangent of half the angle; of who looks the other way, that of a right angle.
  const Value tangent = cross / larger(size, spread<Value>(1e-20F));
  const Value quarter = select(cross < 0.0F, spread<Value>(-1.0F), spread<Value>(1.0F));
  return 2.0F * arcTangent<Value>(select(dot < 0.0F, quarter, tangent));
}

// Where an arc leads: a length and half of the change of heading on it [rad].
template <class Value>
struct ArcLanes {
  Value length, half;
};

// A car that ends the step at `new_speed`, turned to (to_x, to_y) as far as it can. Where it stops
// at the goal, on the arc that ends there.
template <class Value>
PCN_INLINE ArcLanes<Value> arcOf(const StepConstants& c, const RobotLanes<Value>& robot,
                                 const Value& new_speed, const Value& to_x, const Value& to_y,
                                 const typename MaskOf<Value>::Type& stops_at_goal) {
  const Value goal_dx = c.goal_x - robot.x;
  const Value goal_dy = c.goal_y - robot.y;
  const Value goal_angle = turnAngle(robot.direction_x, robot.direction_y, goal_dx, goal_dy);
  Value angle = turnAngle(robot.direction_x, robot.direction_y, to_x, to_y);
  if (c.heads_for_goal) angle = select(stops_at_goal, goal_angle, angle);

  const Value fastest =
      larger(c.instant ? new_speed : larger(robot.speed, new_speed), spread<Value>(1e-6F));
  const Value curvature = smaller(smaller(spread<Value>(c.max_curvature), c.max_yaw_rate / fastest),
                                  c.max_lateral / (fastest * fastest));
  const Value max_turn = spread<Value>(c.max_turn);
  const Value length = c.end_old * robot.speed + c.end_new * new_speed;
  const Value most = smaller(max_turn, curvature * length);
  const Value turned = smaller(larger(angle, -most), most);

  const Value goal_sq = goal_dx * goal_dx + goal_dy * goal_dy;
  const Value goal_length = squareRoot(goal_sq) / sineOver<Value>(goal_angle);
  const Value goal_turn = 2.0F * larger(goal_angle, -goal_angle);
  const Value goal_most = smaller(max_turn, curvature * goal_length);
  // On a ramp it can only slow down so much.
  const Value slowed = larger(robot.speed - c.speed_step, spread<Value>(0.0F));
  const Value least =
      c.instant ? spread<Value>(0.0F) : c.end_old * robot.speed + c.end_new * slowed;
  const auto stops =
      stops_at_goal & (goal_length <= length) & (goal_length >= least) & (goal_turn <= goal_most);
  return {select(stops, goal_length, length), select(stops, goal_angle, 0.5F * turned)};
}

// Moves cars, see moveRobots.
template <class Value, int kVias>
PCN_INLINE MoveLanes<Value, kVias> moveCars(const StepConstants& c, const RobotLanes<Value>& robot,
                                            const Value& new_speed, const ArcLanes<Value>& arc) {
  // The chord to a share of the arc points that share of `half` away from the heading.
  const auto go = [&](const Value& share, Value& x, Value& y, Value& cosine, Value& sine) {
    const Value half = share * arc.half;
    const Value shortening = sineOver<Value>(half);
    cosine = cosineOf<Value>(half);
    sine = half * shortening;
    const Value chord = share * arc.length * shortening;
    x = robot.x + chord * (robot.direction_x * cosine - robot.direction_y * sine);
    y = robot.y + chord * (robot.direction_x * sine + robot.direction_y * cosine);
  };
  MoveLanes<Value, kVias> move;
  Value cosine, sine;
  go(spread<Value>(1.0F), move.end.x, move.end.y, cosine, sine);
  const Value end_cosine = 1.0F - 2.0F * sine * sine;
  const Value end_sine = 2.0F * sine * cosine;
  move.end.direction_x = robot.direction_x * end_cosine - robot.direction_y * end_sine;
  move.end.direction_y = robot.direction_x * end_sine + robot.direction_y * end_cosine;
  move.end.speed = new_speed;
  const Value length =
      larger(c.end_old * robot.speed + c.end_new * new_speed, spread<Value>(1e-6F));
  for (int k = 0; k < viaCount<kVias>(c); ++k) {
    const Value driven = c.via_old[k] * robot.speed + c.via_new[k] * new_speed;
    go(c.instant ? spread<Value>(c.share[k]) : driven / length, move.via_x[k], move.via_y[k],
       cosine, sine);
  }
  return move;
}

}  // namespace pomdp_crowd_nav
