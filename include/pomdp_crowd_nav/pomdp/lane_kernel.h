// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "pomdp_crowd_nav/despot/expansion.h"
#include "pomdp_crowd_nav/pomdp/action.h"
#include "pomdp_crowd_nav/pomdp/robot_state.h"
#include "pomdp_crowd_nav/pomdp/rollout_policy.h"

namespace pomdp_crowd_nav {

// The actions of one expansion and where each takes the robot: what is common to all scenarios.
// Index a is action a; behind `count` nothing is read.
struct ActionMoves {
  int count = 0;
  RobotState robot;        // before the action
  FieldLanes<float> here;  // the field there
  bool arrived = false;    // the robot is at the goal already

  // Given: the action's speed and direction, whether it stops at the goal, its penalty.
  alignas(64) ActionFloats speed, to_x, to_y, brake_penalty;
  alignas(64) ActionFlags follows_prior;

  // Filled in by LaneKernel::move.
  alignas(64) ActionFloats end_x, end_y, end_direction_x, end_direction_y;
  alignas(64) ActionFloats via_x[kMaxVias], via_y[kMaxVias];  // where it is tested on the way
  alignas(64) ActionFloats field_direction_x, field_direction_y, field_clearance;  // at the end
  alignas(64) ActionFlags ends_outside, hits_obstacle;
};

// What the actions bring in one scenario.
struct ScenarioOutcome {
  alignas(64) ActionFloats reward;
  alignas(64) ActionFlags terminal;
  // Discounted return of roll-out p * kMaxActions + a: action a, then policy p to the horizon.
  alignas(64) float values[kMaxRollouts];
  RolloutBatch rollouts;  // holds those that have reached the horizon
};

// What a kernel needs of its surroundings.
struct Evaluation {
  const StepConstants& constants;
  const NavigationField& field;
  const CrowdFutures& futures;
};

// The search's inner loops, compiled once for each vector width.
struct LaneKernel {
  const char* name;

  void (*move)(const Evaluation&, ActionMoves& moves);

  // One scenario of an expansion: the step of every action, then roll-outs from where they end.
  // `start_sq` is the squared distance to the nearest person before the step [m^2].
  void (*evaluate)(const Evaluation&, const ActionMoves& moves, float start_sq, int scenario,
                   int depth, ScenarioOutcome& out, long& steps);
};

// The kernel for the widest vectors of this machine; all give the same results to the bit.
const LaneKernel& laneKernel();

// Every kernel that runs on this machine.
std::vector<const LaneKernel*> laneKernels();

}  // namespace pomdp_crowd_nav
