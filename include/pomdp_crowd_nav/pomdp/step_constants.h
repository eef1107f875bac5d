// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pomdp_crowd_nav/despot/expansion.h"
#include "pomdp_crowd_nav/pomdp/lanes.h"
#include "pomdp_crowd_nav/pomdp/model_params.h"
#include "pomdp_crowd_nav/prior/navigation_field.h"

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

// How many of them are in use.
template <int kVias>
PCN_INLINE int viaCount(const StepConstants& c) {
  return kVias == kHalfWay ? kHalfWay : c.vias;
}

}  // namespace pomdp_crowd_nav
