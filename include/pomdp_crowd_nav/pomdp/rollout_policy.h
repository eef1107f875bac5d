// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pomdp_crowd_nav/pomdp/step_kernel.h"

namespace pomdp_crowd_nav {

// How many roll-outs are followed at once: every action under every policy.
constexpr int kMaxRollouts = kMaxActions * kDefaultPolicies;

// Roll-outs of one scenario, all at the same depth. Those that ended leave the front of the arrays,
// so that the vector lanes stay full while the last ones wait for people to pass.
struct RolloutBatch {
  using Floats = float[kMaxRollouts];
  using Integers = int[kMaxRollouts];

  int count = 0;
  int depth = 0;
  float discount = 1.0F;  // of the step from `depth`
  alignas(64) Floats x, y, direction_x, direction_y, speed;
  alignas(64) Floats field_direction_x, field_direction_y, field_clearance;
  // [m^2] to the nearest person now, or anything beyond the reach of StepConstants.
  alignas(64) Floats nearest_sq;
  alignas(64) Floats near_sq, far_sq;  // [m^2], of the policy that is followed
  alignas(64) Floats value;            // discounted return so far
  alignas(64) Integers alive;          // -1 true, 0 false
  alignas(64) Integers origin;         // which roll-out of the caller's this is

  PCN_INLINE void start(int at_depth) {
    count = 0;
    depth = at_depth;
    discount = 1.0F;
  }
};

// The default policy (paper, section Solving POMDPs Online): direction from the prior, speed from
// the nearest person: slow down within D_near, speed up beyond D_far, else keep.
template <class Value>
PCN_INLINE Value rolloutSpeed(const StepConstants& c, const Value& near_sq, const Value& far_sq,
                              const Value& speed, const Value& nearest_sq) {
  const Value slower = larger(speed - c.speed_step, spread<Value>(0.0F));
  const Value faster = smaller(speed + c.speed_step, spread<Value>(c.max_speed));
  return select(nearest_sq < near_sq, slower, select(nearest_sq > far_sq, faster, speed));
}

// What roll-outs need of their surroundings.
struct RolloutTable {
  StepConstants constants;  // a copy, which the compiler knows that nobody else writes to
  const NavigationField& field;
  const CrowdFutures& futures;
  int scenario;
};

constexpr float kFarAwaySq = std::numeric_limits<float>::max();

// Where one step takes the roll-outs of a register, and what it brings.
template <class Value, int kVias>
struct StepLanes {
  MoveLanes<Value, kVias> move;
  Value nearest_sq;  // [m^2] at the end of the step
  Value reward;      // of the step's end; what it costs to start is left out
  typename MaskOf<Value>::Type collides;
};

template <class Value, int kVias>
PCN_INLINE MoveLanes<Value, kVias> followPrior(const RolloutTable& table,
                                               const RobotLanes<Value>& robot,
                                               const FieldLanes<Value>& here, const Value& speed) {
  using Mask = typename MaskOf<Value>::Type;
  const StepConstants& c = table.constants;
  const Mask has_way = (here.direction_x != 0.0F) | (here.direction_y != 0.0F);
  const Value slower = larger(robot.speed - c.speed_step, spread<Value>(0.0F));
  return moveRobots<Value, kVias>(c, table.field, robot, here, select(has_way, speed, slower),
                                  select(has_way, here.direction_x, robot.direction_x),
                                  select(has_way, here.direction_y, robot.direction_y), has_way);
}

// With nobody within reach: full speed ahead.
template <class Value, int kVias>
PCN_INLINE StepLanes<Value, kVias> stepAlone(const RolloutTable& table,
                                             const RobotLanes<Value>& robot,
                                             const FieldLanes<Value>& here) {
  const StepConstants& c = table.constants;
  StepLanes<Value, kVias> step;
  step.move = followPrior<Value, kVias>(
      table, robot, here, smaller(robot.speed + c.speed_step, spread<Value>(c.max_speed)));
  step.nearest_sq = spread<Value>(kFarAwaySq);
  step.collides = step.move.ends_outside | step.move.hits_obstacle;
  step.reward = select(step.collides, spread<Value>(c.obstacle_penalty), spread<Value>(0.0F));
  return step;
}

template <class Value, int kVias>
PCN_INLINE StepLanes<Value, kVias> stepAmongPeople(const RolloutTable& table,
                                                   const RobotLanes<Value>& robot,
                                                   const FieldLanes<Value>& here, int first,
                                                   const RolloutBatch& batch) {
  const StepConstants& c = table.constants;
  const Value start_sq = load<Value>(batch.nearest_sq + first);
  StepLanes<Value, kVias> step;
  step.move = followPrior<Value, kVias>(
      table, robot, here,
      rolloutSpeed(c, load<Value>(batch.near_sq + first), load<Value>(batch.far_sq + first),
                   robot.speed, start_sq));
  Value via_sq = spread<Value>(kFarAwaySq);
  step.nearest_sq = via_sq;
  meetPeople(c, step.move, table.futures.at(table.scenario, batch.depth),
             table.futures.at(table.scenario, batch.depth + 1), table.futures.personCount(), via_sq,
             step.nearest_sq);
  step.reward =
      collisionPenalty(c, robot, step.move, start_sq, via_sq, step.nearest_sq, step.collides);
  return step;
}

// One step of the roll-outs first, first + 1, ... of a batch. Adds how many of them live on, and
// lowers `nearest_sq` to the nearest person of those.
template <class Value, int kVias>
PCN_INLINE void stepRollouts(const RolloutTable& table, bool is_alone, int first,
                             RolloutBatch& batch, int& living, Value& nearest_sq) {
  using Mask = typename MaskOf<Value>::Type;
  const StepConstants& c = table.constants;
  const RobotLanes<Value> robot{load<Value>(batch.x + first), load<Value>(batch.y + first),
                                load<Value>(batch.direction_x + first),
                                load<Value>(batch.direction_y + first),
                                load<Value>(batch.speed + first)};
  const FieldLanes<Value> here{load<Value>(batch.field_direction_x + first),
                               load<Value>(batch.field_direction_y + first),
                               load<Value>(batch.field_clearance + first)};
  const StepLanes<Value, kVias> step =
      is_alone ? stepAlone<Value, kVias>(table, robot, here)
               : stepAmongPeople<Value, kVias>(table, robot, here, first, batch);
  const Mask arrived = goalDistanceSq(c, robot.x, robot.y) <= c.goal_tolerance_sq;
  const Value reward =
      stepCost(c, robot.speed) + select(arrived, spread<Value>(c.goal_reward), step.reward);
  const Mask alive = loadMask<Mask>(batch.alive + first);
  store(load<Value>(batch.value + first) +
            select(alive, batch.discount * reward, spread<Value>(0.0F)),
        batch.value + first);
  const Mask lives_on = alive & ((arrived | step.collides) == 0);
  store(lives_on, batch.alive + first);
  store(step.move.end.x, batch.x + first);
  store(step.move.end.y, batch.y + first);
  store(step.move.end.direction_x, batch.direction_x + first);
  store(step.move.end.direction_y, batch.direction_y + first);
  store(step.move.end.speed, batch.speed + first);
  store(step.move.field.direction_x, batch.field_direction_x + first);
  store(step.move.field.direction_y, batch.field_direction_y + first);
  store(step.move.field.clearance, batch.field_clearance + first);
  store(step.nearest_sq, batch.nearest_sq + first);
  living += countOf(lives_on);
  nearest_sq = smaller(nearest_sq, select(lives_on, step.nearest_sq, nearest_sq));
}

// Steps that robots this far from everybody can take before anybody is within reach, however all
// of them walk.
PCN_INLINE int stepsAlone(const RolloutTable& table, float nearest_sq) {
  // A ten-thousandth for the rounding of every step on the way.
  const float room = 0.9999F * squareRoot(nearest_sq) - table.constants.reach;
  const float closing = 1.0001F * (table.constants.longest_stride + table.futures.longestStride());
  return room > 0.0F ? static_cast<int>(smaller(room / closing, 1e6F)) : 0;
}

// Where a roll-out begins.
struct RolloutStart {
  RobotLanes<float> robot;
  FieldLanes<float> here;
  float nearest_sq;  // [m^2] to the nearest person
};

PCN_INLINE void addRollout(const RolloutStart& start, const SpeedRule& rule, int origin,
                           RolloutBatch& batch) {
  const int i = batch.count++;
  batch.x[i] = start.robot.x;
  batch.y[i] = start.robot.y;
  batch.direction_x[i] = start.robot.direction_x;
  batch.direction_y[i] = start.robot.direction_y;
  batch.speed[i] = start.robot.speed;
  batch.field_direction_x[i] = start.here.direction_x;
  batch.field_direction_y[i] = start.here.direction_y;
  batch.field_clearance[i] = start.here.clearance;
  batch.nearest_sq[i] = start.nearest_sq;
  batch.near_sq[i] = rule.near_sq;
  batch.far_sq[i] = rule.far_sq;
  batch.value[i] = 0.0F;
  batch.alive[i] = -1;
  batch.origin[i] = origin;
}

PCN_INLINE void copyRollout(RolloutBatch& batch, int from, int to) {
  batch.x[to] = batch.x[from];
  batch.y[to] = batch.y[from];
  batch.direction_x[to] = batch.direction_x[from];
  batch.direction_y[to] = batch.direction_y[from];
  batch.speed[to] = batch.speed[from];
  batch.field_direction_x[to] = batch.field_direction_x[from];
  batch.field_direction_y[to] = batch.field_direction_y[from];
  batch.field_clearance[to] = batch.field_clearance[from];
  batch.nearest_sq[to] = batch.nearest_sq[from];
  batch.near_sq[to] = batch.near_sq[from];
  batch.far_sq[to] = batch.far_sq[from];
  batch.value[to] = batch.value[from];
  batch.alive[to] = batch.alive[from];
  batch.origin[to] = batch.origin[from];
}

// Moves the living to the front and hands over everybody's value.
PCN_INLINE void dropEnded(RolloutBatch& batch, float* values) {
  int kept = 0;
  for (int i = 0; i < batch.count; ++i) {
    values[batch.origin[i]] = batch.value[i];
    if (batch.alive[i] == 0) continue;
    if (kept != i) copyRollout(batch, i, kept);
    ++kept;
  }
  batch.count = kept;
}

// The last register is filled up with roll-outs that count for nothing.
template <class Value>
PCN_INLINE void padLanes(RolloutBatch& batch) {
  for (int i = batch.count; i % kLanesOf<Value> != 0; ++i) {
    copyRollout(batch, 0, i);
    batch.alive[i] = 0;
  }
}

// Follows a batch to the horizon: values[origin] is the discounted return of each roll-out. Those
// that the batch still holds have reached the horizon. Adds the steps it evaluated.
template <class Value, int kVias>
PCN_INLINE void rollOut(const RolloutTable& table, RolloutBatch& batch, float* values,
                        long& steps) {
  int alone_until = 0;
  int living = batch.count;
  padLanes<Value>(batch);
  while (living > 0 && batch.depth < table.futures.depth()) {
    const bool is_alone = batch.depth < alone_until;
    Value nearest_sq = spread<Value>(kFarAwaySq);
    steps += living;
    living = 0;
    for (int first = 0; first < batch.count; first += kLanesOf<Value>) {
      stepRollouts<Value, kVias>(table, is_alone, first, batch, living, nearest_sq);
    }
    ++batch.depth;
    batch.discount *= table.constants.discount;
    if (!is_alone) alone_until = batch.depth + stepsAlone(table, smallestOf(nearest_sq));
    if (living > 0 && living + kLanesOf<Value> <= batch.count) {
      dropEnded(batch, values);
      padLanes<Value>(batch);
    }
  }
  dropEnded(batch, values);
}

}  // namespace pomdp_crowd_nav
