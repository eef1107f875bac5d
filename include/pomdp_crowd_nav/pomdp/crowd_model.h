// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pomdp_crowd_nav/despot/expansion.h"
#include "pomdp_crowd_nav/pomdp/action.h"
#include "pomdp_crowd_nav/pomdp/lane_kernel.h"
#include "pomdp_crowd_nav/pomdp/robot_state.h"
#include "pomdp_crowd_nav/pomdp/rollout_policy.h"
#include "pomdp_crowd_nav/pomdp/upper_bound.h"

namespace pomdp_crowd_nav {

// What a model knows of the map.
struct MapTables {
  MapTables(const NavigationField& some_field, const ShortestWay* some_shortest_way = nullptr)
      : field(some_field), shortest_way(some_shortest_way) {}

  const NavigationField& field;
  const ShortestWay* shortest_way;  // for a tighter upper bound, or nullptr
};

// The navigation POMDP as a model for the DESPOT search: actions in vector lanes, people from the
// table of futures, leaves valued by roll-outs along the prior.
//
// Refers to the tables, the futures and the kernel, which must outlive it. Its expand is const and
// thread-safe.
class CrowdModel {
 public:
  using State = RobotState;
  using Action = pomdp_crowd_nav::Action;
  static constexpr bool kSharesState = true;  // the robot's state; people are in the futures

  // `kernel`: one of laneKernels(); all give the same values.
  CrowdModel(const ModelParams& params, const MapTables& map, const CrowdFutures& futures,
             const LaneKernel& kernel = laneKernel());

  void expand(const RobotState* states, const int* scenarios, int count, int depth,
              Expansion<CrowdModel>& out) const;
  void rootBounds(const RobotState* states, const int* scenarios, int count, double& lower,
                  double& upper) const;

  // What the default policy does at the root, as a legal action.
  Action defaultAction(const RobotState* state) const;

  const std::vector<Action>& legalActions(const RobotState& state) const;

  // Speed after an action [m/s].
  float speedAfter(const RobotState& state, const Action& action) const;

  // Where an action takes the robot, people left aside.
  RobotState move(const RobotState& state, const Action& action) const;

  // One action in one scenario, lane by lane code on a single float: the twin of `expand` for
  // tests, and the model's step for anybody who wants a single one.
  Branch step(const RobotState& state, int scenario, int depth, const Action& action,
              RobotState& next) const;

  const StepConstants& constants() const { return constants_; }

 private:
  const ActionSet& actionSet(const RobotState& state) const;
  bool canFollowPrior(const RobotState& state) const;
  // To the direction of the prior [rad], of a car; cut off at a right angle.
  float angleToPrior(const RobotState& state) const;
  void prepareMoves(const RobotState& state, const ActionSet& set, ActionMoves& moves) const;
  void addBeyondHorizon(ScenarioOutcome& outcome) const;
  template <int kVias>
  MoveLanes<float, kVias> moveOne(const RobotState& state, const Action& action) const;
  template <int kVias>
  Branch stepBy(const RobotState& state, int scenario, int depth, const Action& action,
                RobotState& next) const;
  float rollOutOne(const RobotState& state, const FieldLanes<float>& here, float start_sq,
                   int scenario, int depth, int policy) const;
  float beyondHorizon(const RobotState& state) const;

  ModelParams params_;
  const NavigationField& field_;
  const CrowdFutures& futures_;
  const LaneKernel& kernel_;
  StepConstants constants_;
  UpperBound upper_bound_;
  ActionSets action_sets_;
};

}  // namespace pomdp_crowd_nav
