// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pomdp_crowd_nav/despot/expansion.h"
#include "pomdp_crowd_nav/pomdp/rollout_policy.h"

namespace pomdp_crowd_nav {

// What is common to all scenarios of an expansion: where each action takes the robot. Lane a holds
// action a.
struct ActionLanes {
  RobotLanes<Lanes> robot;  // before the action, the same in every lane
  MoveLanes<Lanes> move;
  Lanes brake_penalty;
  LaneMask used;     // lanes that hold an action
  LaneMask arrived;  // the robot is at the goal already
};

// What a kernel needs of its surroundings.
struct Evaluation {
  const StepConstants& constants;
  const NavigationField& field;
  const CrowdFutures& futures;
};

// What the actions bring in one scenario.
struct ScenarioOutcome {
  Lanes reward;
  LaneMask terminal;
  struct Rollouts {
    Lanes value;
    float discount = 1.0F;      // left at their end
    RobotLanes<Lanes> horizon;  // robots where they ended
    LaneMask reached_horizon;
  };
  Rollouts rollouts[kDefaultPolicies];
};

// The search's inner loops, compiled once for each vector width.
struct LaneKernel {
  const char* name;

  // Fills lanes.move and lanes.arrived from the speed and direction of each action.
  void (*move)(const Evaluation&, const Lanes& speed, const Lanes& to_x, const Lanes& to_y,
               const LaneMask& follows_prior, const FieldLanes<Lanes>& here, ActionLanes& lanes);

  // One scenario of an expansion: the step of every action, then roll-outs from where they end.
  // `start_sq` is the squared distance to the nearest person before the step [m^2].
  void (*evaluate)(const Evaluation&, const ActionLanes& lanes, float start_sq, int scenario,
                   int depth, ScenarioOutcome& out, long& steps);
};

// The kernel for the widest vectors of this machine; all give the same results to the bit.
const LaneKernel& laneKernel();

// Every kernel that runs on this machine.
std::vector<const LaneKernel*> laneKernels();

}  // namespace pomdp_crowd_nav
