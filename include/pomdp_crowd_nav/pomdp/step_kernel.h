// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pomdp_crowd_nav/pomdp/car_kernel.h"
#include "pomdp_crowd_nav/pomdp/crowd_futures.h"

// One step of the POMDP's generative model G (paper, section Generative Model), as formulas on
// a Value that is one float or sixteen. All lanes of one call are robots in the same scenario at
// the same depth, so that they meet the same people.
namespace pomdp_crowd_nav {

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
