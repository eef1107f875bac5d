// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <limits>

#include "pomdp_crowd_nav/despot/expansion.h"
#include "pomdp_crowd_nav/pomdp/crowd_futures.h"
#include "pomdp_crowd_nav/pomdp/lanes.h"
#include "pomdp_crowd_nav/pomdp/model_params.h"
#include "pomdp_crowd_nav/prior/navigation_field.h"

// One step of the POMDP's generative model G (paper, section Generative Model), as formulas on
// a Value that is one float or sixteen. All lanes of one call are robots in the same scenario at
// the same depth, so that they meet the same people.
namespace pomdp_crowd_nav {

// Tests of a step before the one at its end. Kernels are compiled for kHalfWay, the usual case, and
// for kMaxVias, of which StepConstants::vias are in use.
constexpr int kHalfWay = 1;
constexpr int kMaxVias = kMaxCollisionChecks - 1;

// Distances at which a roll-out slows down and speeds up, squared [m^2].
struct SpeedRule {
  float near_sq, far_sq;
};

// ModelParams turned into what a step multiplies with.
struct StepConstants {
  float max_speed, speed_step, brake_step;  // [m/s], brake_step: lost in a step of sudden brake
  float turn_speed;                         // [m/s], lateral velocity change in a step
  float end_old, end_new;  // [s], displacement at the end of a step per old and new velocity
  int vias;                // tests of a step before the one at its end
  float share[kMaxVias];   // of the step, when they are made
  float via_old[kMaxVias], via_new[kMaxVias];  // [s], as end_old and end_new
  float goal_x, goal_y, goal_tolerance_sq;
  float min_x, min_y, max_x, max_y;
  float pedestrian_clearance_sq, obstacle_clearance;
  SpeedRule rules[kDefaultPolicies];  // of the roll-outs: the paper's and a bolder one
  int policy_count;                   // how many of them are in use
  float reach;  // [m] who is farther away changes nothing; a little more than the distances tested
  float longest_stride;  // [m], of the robot in a step
  float goal_reward, pedestrian_penalty, obstacle_penalty, brake_penalty;
  float time_cost, low_speed_cost;  // per step; low_speed_cost at rest
  float discount;
  bool has_obstacles;
  bool instant;
  bool is_car;
  bool heads_for_goal;              // the prior is the straight line: its direction is exact
  float max_curvature;              // [1/m], of a car
  float max_turn;                   // [rad], of a car in a step
  float max_yaw_rate, max_lateral;  // [rad/s], [m/s^2], of a car

  StepConstants(const ModelParams& params, const NavigationField& field);

  // A holonomic base that is tested half way and at the end: the case that has kernels of its own.
  bool isUsual() const { return !is_car && vias == kHalfWay; }
};

template <int kVias>
PCN_INLINE int viaCount(const StepConstants& c) {
  return kVias == kHalfWay ? kHalfWay : c.vias;
}

struct Offset {
  float x, y;  // [m]
};

template <class Value>
struct RobotLanes {
  Value x, y, direction_x, direction_y, speed;
};

// What the field says at the robots' places.
template <class Value>
struct FieldLanes {
  Value direction_x, direction_y, clearance;
};

// Where a step takes the robots, people left aside.
template <class Value, int kVias = kHalfWay>
struct MoveLanes {
  using Mask = typename MaskOf<Value>::Type;
  RobotLanes<Value> end;
  Value via_x[kVias], via_y[kVias];  // where it is tested on the way
  FieldLanes<Value> field;           // at the end
  Mask ends_outside;
  Mask hits_obstacle;
};

PCN_INLINE FieldLanes<float> lookUp(const NavigationField& field, float x, float y) {
  const NavigationCell cell = field.at(x, y);
  return {cell.direction_x, cell.direction_y, cell.clearance};
}

template <class Value>
PCN_INLINE typename MaskOf<Value>::Type cellsOf(const NavigationField& field, const Value& x,
                                                const Value& y) {
  using Mask = typename MaskOf<Value>::Type;
  const NavigationField::Raster& raster = field.raster();
  const Value zero = spread<Value>(raster.zero);
  const Value from_left = (x - raster.min_x) * raster.cells_per_meter;
  const Value from_bottom = (y - raster.min_y) * raster.cells_per_meter;
  const Value column = smaller(larger(from_left, zero), spread<Value>(raster.last_column));
  const Value row = smaller(larger(from_bottom, zero), spread<Value>(raster.last_row));
  return __builtin_convertvector(row, Mask) * raster.columns +
         __builtin_convertvector(column, Mask);
}

template <class Value>
PCN_INLINE FieldLanes<Value> lookUp(const NavigationField& field, const Value& x, const Value& y) {
  using Mask = typename MaskOf<Value>::Type;
  const Mask cells = cellsOf<Value>(field, x, y);
  const Mask packed = gather(field.directions(), cells);
  FieldLanes<Value> lanes;
  lanes.direction_x = __builtin_convertvector((packed << 16) >> 16, Value) * kPackedUnit;
  lanes.direction_y = __builtin_convertvector(packed >> 16, Value) * kPackedUnit;
  lanes.clearance =
      field.hasObstacles() ? gather<Value>(field.clearances(), cells) : spread<Value>(1e6F);
  return lanes;
}

PCN_INLINE float clearanceAt(const NavigationField& field, float x, float y) {
  return field.clearances()[field.cellOf(x, y)];
}
template <class Value>
PCN_INLINE Value clearanceAt(const NavigationField& field, const Value& x, const Value& y) {
  return gather<Value>(field.clearances(), cellsOf<Value>(field, x, y));
}

// R_t + R_speed: what a step costs that starts at `speed`.
template <class Value>
PCN_INLINE Value stepCost(const StepConstants& c, const Value& speed) {
  return c.time_cost + c.low_speed_cost * ((c.max_speed - speed) * (1.0F / c.max_speed));
}

template <class Value>
PCN_INLINE Value goalDistanceSq(const StepConstants& c, const Value& x, const Value& y) {
  const Value dx = c.goal_x - x;
  const Value dy = c.goal_y - y;
  return dx * dx + dy * dy;
}

// Turns the direction of travel toward a desired one as far as lateral acceleration allows:
// speed * |u' - u| <= turn_speed (see maxTurnChord).
template <class Value>
PCN_INLINE void turn(const StepConstants& c, const RobotLanes<Value>& robot, Value& to_x,
                     Value& to_y) {
  const Value dot = robot.direction_x * to_x + robot.direction_y * to_y;
  const Value cross = robot.direction_x * to_y - robot.direction_y * to_x;
  const Value speed = larger(robot.speed, spread<Value>(1e-6F));
  const Value chord = smaller(c.turn_speed / speed, spread<Value>(2.0F));
  const Value cosine = 1.0F - 0.5F * chord * chord;
  const Value half = larger(1.0F - 0.25F * chord * chord, spread<Value>(0.0F));
  const Value sine_size = chord * squareRoot(half);
  const Value sine = select(cross < 0.0F, -sine_size, sine_size);
  const Value turned_x = robot.direction_x * cosine - robot.direction_y * sine;
  const Value turned_y = robot.direction_x * sine + robot.direction_y * cosine;
  const auto reachable = dot >= cosine - 1e-6F;
  to_x = select(reachable, to_x, turned_x);
  to_y = select(reachable, to_y, turned_y);
}

// Squared cosine of the angle within which something lies ahead.
constexpr float kAheadSq = 0.95F * 0.95F;

// How far robots get in a step, and where they are tested on the way.
template <class Value, int kVias>
struct WayLanes {
  using Mask = typename MaskOf<Value>::Type;
  Value end_x, end_y, via_x[kVias], via_y[kVias];  // [m], from the start
  Mask passes_goal;
};

// A base that takes any velocity at once.
template <class Value, int kVias>
PCN_INLINE WayLanes<Value, kVias> wayAtOnce(const StepConstants& c, const Value& goal_sq,
                                            const RobotLanes<Value>& end) {
  const Value length = c.end_new * end.speed;
  WayLanes<Value, kVias> way;
  way.end_x = length * end.direction_x;
  way.end_y = length * end.direction_y;
  for (int k = 0; k < viaCount<kVias>(c); ++k) {
    way.via_x[k] = c.share[k] * way.end_x;
    way.via_y[k] = c.share[k] * way.end_y;
  }
  way.passes_goal = length * length >= goal_sq;
  return way;
}

// A base whose velocity is a ramp from the old to the new; it passes only what lies ahead.
template <class Value, int kVias>
PCN_INLINE WayLanes<Value, kVias> wayOnRamp(const StepConstants& c, const RobotLanes<Value>& robot,
                                            const RobotLanes<Value>& end, const Value& goal_dx,
                                            const Value& goal_dy) {
  const Value old_x = robot.speed * robot.direction_x;
  const Value old_y = robot.speed * robot.direction_y;
  const Value new_x = end.speed * end.direction_x;
  const Value new_y = end.speed * end.direction_y;
  WayLanes<Value, kVias> way;
  way.end_x = c.end_old * old_x + c.end_new * new_x;
  way.end_y = c.end_old * old_y + c.end_new * new_y;
  for (int k = 0; k < viaCount<kVias>(c); ++k) {
    way.via_x[k] = c.via_old[k] * old_x + c.via_new[k] * new_x;
    way.via_y[k] = c.via_old[k] * old_y + c.via_new[k] * new_y;
  }
  const Value length_sq = way.end_x * way.end_x + way.end_y * way.end_y;
  const Value goal_sq = goal_dx * goal_dx + goal_dy * goal_dy;
  const Value dot = way.end_x * goal_dx + way.end_y * goal_dy;
  way.passes_goal = length_sq >= goal_sq;
  way.passes_goal = way.passes_goal & (dot > 0.0F) & (dot * dot >= kAheadSq * length_sq * goal_sq);
  return way;
}

// Whether a robot that is at the places of `move`, and stands still unless `moves`, comes into the
// margin of an obstacle. Moving out of the margin is allowed to who is in it already, and to nobody
// else.
template <class Value, int kVias>
PCN_INLINE typename MaskOf<Value>::Type hitsObstacle(const StepConstants& c,
                                                     const NavigationField& field,
                                                     const FieldLanes<Value>& here,
                                                     const MoveLanes<Value, kVias>& move,
                                                     const typename MaskOf<Value>::Type& moves) {
  const Value obstacle_clearance = spread<Value>(c.obstacle_clearance);
  const Value margin =
      select(here.clearance > obstacle_clearance, obstacle_clearance, here.clearance - 1e-3F);
  typename MaskOf<Value>::Type hits = move.field.clearance <= margin;
  for (int k = 0; k < viaCount<kVias>(c); ++k) {
    hits = hits | (clearanceAt(field, move.via_x[k], move.via_y[k]) <= margin);
  }
  return moves & hits;
}

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
  const auto stops = stops_at_goal & (goal_length <= length) & (goal_turn <= goal_most);
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

// What the map says of a move; who does not move hits nothing.
template <class Value, int kVias>
PCN_INLINE void lookAround(const StepConstants& c, const NavigationField& field,
                           const FieldLanes<Value>& here, const typename MaskOf<Value>::Type& moves,
                           MoveLanes<Value, kVias>& move) {
  move.ends_outside = moves & ((move.end.x < c.min_x) | (move.end.x > c.max_x) |
                               (move.end.y < c.min_y) | (move.end.y > c.max_y));
  move.field = lookUp(field, move.end.x, move.end.y);
  move.hits_obstacle =
      c.has_obstacles ? hitsObstacle(c, field, here, move, moves) : typename MaskOf<Value>::Type{};
}

// Moves robots to `new_speed` in direction (to_x, to_y). Where `stops_at_goal`, a robot that
// would pass the goal ends on it. `here` is the field at the start.
template <class Value, int kVias = kHalfWay>
PCN_INLINE MoveLanes<Value, kVias> moveRobots(const StepConstants& c, const NavigationField& field,
                                              const RobotLanes<Value>& robot,
                                              const FieldLanes<Value>& here, const Value& new_speed,
                                              Value to_x, Value to_y,
                                              const typename MaskOf<Value>::Type& stops_at_goal) {
  MoveLanes<Value, kVias> move;
  if (kVias != kHalfWay && c.is_car) {
    const ArcLanes<Value> arc = arcOf<Value>(c, robot, new_speed, to_x, to_y, stops_at_goal);
    move = moveCars<Value, kVias>(c, robot, new_speed, arc);
    lookAround<Value, kVias>(c, field, here, arc.length > 0.0F, move);
    return move;
  }
  if (!c.instant) turn(c, robot, to_x, to_y);
  move.end = {robot.x, robot.y, to_x, to_y, new_speed};
  const Value goal_dx = c.goal_x - robot.x;
  const Value goal_dy = c.goal_y - robot.y;
  WayLanes<Value, kVias> way =
      c.instant ? wayAtOnce<Value, kVias>(c, goal_dx * goal_dx + goal_dy * goal_dy, move.end)
                : wayOnRamp<Value, kVias>(c, robot, move.end, goal_dx, goal_dy);
  const auto passes = stops_at_goal & way.passes_goal;
  way.end_x = select(passes, goal_dx, way.end_x);
  way.end_y = select(passes, goal_dy, way.end_y);
  for (int k = 0; k < viaCount<kVias>(c); ++k) {
    move.via_x[k] = robot.x + select(passes, c.share[k] * goal_dx, way.via_x[k]);
    move.via_y[k] = robot.y + select(passes, c.share[k] * goal_dy, way.via_y[k]);
  }
  move.end.x += way.end_x;
  move.end.y += way.end_y;

  const auto moves = (way.end_x * way.end_x + way.end_y * way.end_y) > 0.0F;
  lookAround<Value, kVias>(c, field, here, moves, move);
  return move;
}

// Where a person is at the k-th test of a step, who walks straight from `from` to `to`.
template <int kVias>
PCN_INLINE Offset placeOf(const StepConstants& c, const CrowdFutures::Place& from,
                          const CrowdFutures::Place& to, int k) {
  if (kVias == kHalfWay) return {from.mid_x, from.mid_y};
  return {from.x + c.share[k] * (to.x - from.x), from.y + c.share[k] * (to.y - from.y)};
}

// Smallest squared distance of each robot to anybody, in the tests on the way and at the end of a
// step.
template <class Value, int kVias>
PCN_INLINE void meetPeople(const StepConstants& c, const MoveLanes<Value, kVias>& move,
                           const CrowdFutures::Place* from, const CrowdFutures::Place* to,
                           int count, Value& via_sq, Value& end_sq) {
  for (int i = 0; i < count; ++i) {
    for (int k = 0; k < viaCount<kVias>(c); ++k) {
      const Offset person = placeOf<kVias>(c, from[i], to[i], k);
      const Value via_dx = move.via_x[k] - person.x;
      const Value via_dy = move.via_y[k] - person.y;
      via_sq = smaller(via_sq, via_dx * via_dx + via_dy * via_dy);
    }
    const Value end_dx = move.end.x - to[i].x;
    const Value end_dy = move.end.y - to[i].y;
    end_sq = smaller(end_sq, end_dx * end_dx + end_dy * end_dy);
  }
}

// Penalty of a step by its first cause, in the order of the authors' model, and whether there is
// any. `start_sq` is the squared distance to the nearest person at the start of the step.
template <class Value, int kVias>
PCN_INLINE Value collisionPenalty(const StepConstants& c, const RobotLanes<Value>& robot,
                                  const MoveLanes<Value, kVias>& move, const Value& start_sq,
                                  const Value& via_sq, const Value& end_sq,
                                  typename MaskOf<Value>::Type& collides) {
  // Who moves before or after, is tested where the step starts, on the way, and where it ends.
  const auto starts_close =
      ((robot.speed > 0.0F) | (move.end.speed > 0.0F)) & (start_sq <= c.pedestrian_clearance_sq);
  auto comes_close =
      (move.end.speed > 0.0F) & (smaller(via_sq, end_sq) <= c.pedestrian_clearance_sq);
  if (!c.instant) {  // a base that brakes to rest moves until then
    comes_close = comes_close | ((robot.speed > 0.0F) & (via_sq <= c.pedestrian_clearance_sq));
  }
  const auto meets_person = starts_close | comes_close;
  collides = move.ends_outside | meets_person | move.hits_obstacle;
  const auto is_obstacle = move.ends_outside | (move.hits_obstacle & (meets_person == 0));
  return select(is_obstacle, spread<Value>(c.obstacle_penalty),
                select(collides, spread<Value>(c.pedestrian_penalty), spread<Value>(0.0F)));
}

}  // namespace pomdp_crowd_nav
