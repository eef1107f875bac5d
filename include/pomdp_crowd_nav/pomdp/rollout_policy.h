// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pomdp_crowd_nav/pomdp/step_kernel.h"

namespace pomdp_crowd_nav {

// The default policy (paper, section Solving POMDPs Online): direction from the prior, speed from
// the nearest person: slow down within D_near, speed up beyond D_far, else keep.
template <class Value>
PCN_INLINE Value rolloutSpeed(const StepConstants& c, const SpeedRule& rule, const Value& speed,
                              const Value& nearest_sq) {
  const Value slower = larger(speed - c.speed_step, spread<Value>(0.0F));
  const Value faster = smaller(speed + c.speed_step, spread<Value>(c.max_speed));
  return select(nearest_sq < rule.near_sq, slower, select(nearest_sq > rule.far_sq, faster, speed));
}

// Robots about to follow the default policy in one scenario from one depth.
template <class Value>
struct RolloutStart {
  using Mask = typename MaskOf<Value>::Type;
  RobotLanes<Value> robot;
  FieldLanes<Value> here;
  Value nearest_sq;  // [m^2] to the nearest person now
  Mask alive;        // lanes to roll out
};

// Discounted return from here to the horizon in each living lane, 0 in the others; where a lane
// reaches the horizon, `beyond` has its robot. Adds the steps it evaluated.
template <class Value>
PCN_INLINE Value rollOut(const StepConstants& c, const SpeedRule& rule,
                         const NavigationField& field, const CrowdFutures& futures, int scenario,
                         int depth, RolloutStart<Value>& lanes, float& discount_left, long& steps) {
  using Mask = typename MaskOf<Value>::Type;
  Value value = spread<Value>(0.0F);
  const int count = futures.personCount();
  float discount = 1.0F;
  TrueCount<Mask> evaluated;
  for (; depth < futures.depth() && anyOf(lanes.alive); ++depth) {
    RobotLanes<Value>& robot = lanes.robot;
    evaluated.add(lanes.alive);
    const Mask arrived = goalDistanceSq(c, robot.x, robot.y) <= c.goal_tolerance_sq;
    const Value to_x = lanes.here.direction_x;
    const Value to_y = lanes.here.direction_y;
    const Mask has_way = (to_x * to_x + to_y * to_y) > 0.5F;
    const Value slower = larger(robot.speed - c.speed_step, spread<Value>(0.0F));
    const Value speed =
        select(has_way, rolloutSpeed(c, rule, robot.speed, lanes.nearest_sq), slower);
    const MoveLanes<Value> move = moveRobots<Value>(
        c, field, robot, lanes.here, speed, select(has_way, to_x, robot.direction_x),
        select(has_way, to_y, robot.direction_y), has_way);
    Value mid_sq = spread<Value>(std::numeric_limits<float>::max());
    Value end_sq = mid_sq;
    meetPeople(move, futures.at(scenario, depth), futures.at(scenario, depth + 1), count, mid_sq,
               end_sq);
    Mask collides;
    const Value penalty =
        collisionPenalty(c, robot, move, lanes.nearest_sq, mid_sq, end_sq, collides);
    const Value reward =
        stepCost(c, robot.speed) + select(arrived, spread<Value>(c.goal_reward), penalty);
    value += select(lanes.alive, discount * reward, spread<Value>(0.0F));
    lanes.alive = lanes.alive & ((arrived | collides) == 0);
    lanes.robot = move.end;
    lanes.here = move.field;
    lanes.nearest_sq = end_sq;
    discount *= c.discount;
  }
  discount_left = discount;
  steps += evaluated.total();
  return value;
}

}  // namespace pomdp_crowd_nav
