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

// Distances at which a roll-out slows down and speeds up, squared [m^2].
struct SpeedRule {
  float near_sq, far_sq;
};

// ModelParams turned into what a step multiplies with.
struct StepConstants {
  float max_speed, speed_step, brake_step;  // [m/s], brake_step: lost in a step of sudden brake
  float turn_speed;                         // [m/s], lateral velocity change in a step
  float end_old, end_new;  // [s], displacement at the end of a step per old and new velocity
  float mid_old, mid_new;  // [s], the same half a step in
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

  StepConstants(const ModelParams& params, const NavigationField& field);
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
template <class Value>
struct MoveLanes {
  using Mask = typename MaskOf<Value>::Type;
  RobotLanes<Value> end;
  Value mid_x, mid_y;
  FieldLanes<Value> field;  // at the end
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

// How far robots get in a step, and where they are half way.
template <class Value>
struct WayLanes {
  using Mask = typename MaskOf<Value>::Type;
  Value end_x, end_y, mid_x, mid_y;  // [m], from the start
  Mask passes_goal;
};

// A base that takes any velocity at once.
template <class Value>
PCN_INLINE WayLanes<Value> wayAtOnce(const StepConstants& c, const Value& goal_sq,
                                     const RobotLanes<Value>& end) {
  const Value length = c.end_new * end.speed;
  const Value end_x = length * end.direction_x;
  const Value end_y = length * end.direction_y;
  return {end_x, end_y, 0.5F * end_x, 0.5F * end_y, length * length >= goal_sq};
}

// A base whose velocity is a ramp from the old to the new; it passes only what lies ahead.
template <class Value>
PCN_INLINE WayLanes<Value> wayOnRamp(const StepConstants& c, const RobotLanes<Value>& robot,
                                     const RobotLanes<Value>& end, const Value& goal_dx,
                                     const Value& goal_dy) {
  const Value old_x = robot.speed * robot.direction_x;
  const Value old_y = robot.speed * robot.direction_y;
  const Value new_x = end.speed * end.direction_x;
  const Value new_y = end.speed * end.direction_y;
  const Value end_x = c.end_old * old_x + c.end_new * new_x;
  const Value end_y = c.end_old * old_y + c.end_new * new_y;
  const Value length_sq = end_x * end_x + end_y * end_y;
  const Value goal_sq = goal_dx * goal_dx + goal_dy * goal_dy;
  const Value dot = end_x * goal_dx + end_y * goal_dy;
  typename MaskOf<Value>::Type passes = length_sq >= goal_sq;
  passes = passes & (dot > 0.0F) & (dot * dot >= kAheadSq * length_sq * goal_sq);
  return {end_x, end_y, c.mid_old * old_x + c.mid_new * new_x,
          c.mid_old * old_y + c.mid_new * new_y, passes};
}

// Moves robots to `new_speed` in direction (to_x, to_y). Where `stops_at_goal`, a robot that
// would pass the goal ends on it. `here` is the field at the start.
template <class Value>
PCN_INLINE MoveLanes<Value> moveRobots(const StepConstants& c, const NavigationField& field,
                                       const RobotLanes<Value>& robot,
                                       const FieldLanes<Value>& here, const Value& new_speed,
                                       Value to_x, Value to_y,
                                       const typename MaskOf<Value>::Type& stops_at_goal) {
  if (!c.instant) turn(c, robot, to_x, to_y);
  MoveLanes<Value> move;
  move.end = {robot.x, robot.y, to_x, to_y, new_speed};
  const Value goal_dx = c.goal_x - robot.x;
  const Value goal_dy = c.goal_y - robot.y;
  WayLanes<Value> way = c.instant
                            ? wayAtOnce<Value>(c, goal_dx * goal_dx + goal_dy * goal_dy, move.end)
                            : wayOnRamp<Value>(c, robot, move.end, goal_dx, goal_dy);
  const auto passes = stops_at_goal & way.passes_goal;
  way.end_x = select(passes, goal_dx, way.end_x);
  way.end_y = select(passes, goal_dy, way.end_y);
  move.mid_x = robot.x + select(passes, 0.5F * goal_dx, way.mid_x);
  move.mid_y = robot.y + select(passes, 0.5F * goal_dy, way.mid_y);
  move.end.x += way.end_x;
  move.end.y += way.end_y;

  const auto moves = (way.end_x * way.end_x + way.end_y * way.end_y) > 0.0F;
  move.ends_outside = moves & ((move.end.x < c.min_x) | (move.end.x > c.max_x) |
                               (move.end.y < c.min_y) | (move.end.y > c.max_y));
  move.field = lookUp(field, move.end.x, move.end.y);
  move.hits_obstacle = typename MaskOf<Value>::Type{};
  if (c.has_obstacles) {
    // Moving out of the margin is allowed to who is in it already, and to nobody else.
    const Value obstacle_clearance = spread<Value>(c.obstacle_clearance);
    const Value margin =
        select(here.clearance > obstacle_clearance, obstacle_clearance, here.clearance - 1e-3F);
    const Value mid = clearanceAt(field, move.mid_x, move.mid_y);
    move.hits_obstacle = moves & ((mid <= margin) | (move.field.clearance <= margin));
  }
  return move;
}

// Smallest squared distance of each robot to anybody, half a step in and at its end; people walk
// straight from `from` to `to`.
template <class Value>
PCN_INLINE void meetPeople(const MoveLanes<Value>& move, const CrowdFutures::Place* from,
                           const CrowdFutures::Place* to, int count, Value& mid_sq, Value& end_sq) {
  for (int i = 0; i < count; ++i) {
    const Value mid_dx = move.mid_x - from[i].mid_x;
    const Value mid_dy = move.mid_y - from[i].mid_y;
    mid_sq = smaller(mid_sq, mid_dx * mid_dx + mid_dy * mid_dy);
    const Value end_dx = move.end.x - to[i].x;
    const Value end_dy = move.end.y - to[i].y;
    end_sq = smaller(end_sq, end_dx * end_dx + end_dy * end_dy);
  }
}

// Penalty of a step by its first cause, in the order of the authors' model, and whether there is
// any. `start_sq` is the squared distance to the nearest person at the start of the step.
template <class Value>
PCN_INLINE Value collisionPenalty(const StepConstants& c, const RobotLanes<Value>& robot,
                                  const MoveLanes<Value>& move, const Value& start_sq,
                                  const Value& mid_sq, const Value& end_sq,
                                  typename MaskOf<Value>::Type& collides) {
  // Who moves before or after, is tested where the step starts, half way, and where it ends.
  const auto starts_close =
      ((robot.speed > 0.0F) | (move.end.speed > 0.0F)) & (start_sq <= c.pedestrian_clearance_sq);
  auto comes_close =
      (move.end.speed > 0.0F) & (smaller(mid_sq, end_sq) <= c.pedestrian_clearance_sq);
  if (!c.instant) {  // a base that brakes to rest moves until then
    comes_close = comes_close | ((robot.speed > 0.0F) & (mid_sq <= c.pedestrian_clearance_sq));
  }
  const auto meets_person = starts_close | comes_close;
  collides = move.ends_outside | meets_person | move.hits_obstacle;
  const auto is_obstacle = move.ends_outside | (move.hits_obstacle & (meets_person == 0));
  return select(is_obstacle, spread<Value>(c.obstacle_penalty),
                select(collides, spread<Value>(c.pedestrian_penalty), spread<Value>(0.0F)));
}

}  // namespace pomdp_crowd_nav
