// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/pomdp/crowd_model.h"

#include <algorithm>
#include <cmath>

namespace pomdp_crowd_nav {
namespace {

float nearestSq(const CrowdFutures::Place* people, int count, float x, float y) {
  float nearest = kFarAwaySq;
  for (int i = 0; i < count; ++i) {
    const float dx = people[i].x - x;
    const float dy = people[i].y - y;
    nearest = std::min(nearest, dx * dx + dy * dy);
  }
  return nearest;
}

}  // namespace

CrowdModel::CrowdModel(const ModelParams& params, const MapTables& map, const CrowdFutures& futures,
                       const LaneKernel& kernel)
    : params_(params),
      field_(map.field),
      futures_(futures),
      kernel_(kernel),
      constants_(params, map.field),
      upper_bound_(params, map.field.goal(), map.shortest_way) {
  validate(params);
}

const ActionSet& CrowdModel::actionSet(const RobotState& state) const {
  return action_sets_.legal(state.speed > 0.0F, canFollowPrior(state));
}

// A car that would have to turn farther than it can has that turn among its actions already.
bool CrowdModel::canFollowPrior(const RobotState& state) const {
  const NavigationCell here = field_.at(state.x, state.y);
  if (here.direction_x == 0.0F && here.direction_y == 0.0F) return false;
  return !constants_.is_car || std::abs(angleToPrior(state)) < constants_.max_turn;
}

float CrowdModel::angleToPrior(const RobotState& state) const {
  const NavigationCell here = field_.at(state.x, state.y);
  const bool exact = constants_.heads_for_goal;
  return turnAngle<float>(state.direction_x, state.direction_y,
                          exact ? constants_.goal_x - state.x : here.direction_x,
                          exact ? constants_.goal_y - state.y : here.direction_y);
}

const std::vector<Action>& CrowdModel::legalActions(const RobotState& state) const {
  return actionSet(state).actions;
}

float CrowdModel::speedAfter(const RobotState& state, const Action& action) const {
  if (action.sudden_brake) return std::max(0.0F, state.speed - constants_.brake_step);
  const float changed =
      state.speed + static_cast<float>(action.speed_steps) * constants_.speed_step;
  return std::min(std::max(changed, 0.0F), constants_.max_speed);
}

void CrowdModel::expand(const RobotState* states, const int* scenarios, int count, int depth,
                        Expansion<CrowdModel>& out) const {
  const RobotState& state = states[0];
  out.reset();
  const ActionSet& set = actionSet(state);
  out.actions = set.actions;
  const int action_count = static_cast<int>(out.actions.size());
  const Evaluation evaluation{constants_, field_, futures_};
  ActionMoves moves;
  prepareMoves(state, set, moves);
  kernel_.move(evaluation, moves);

  float uppers[kMaxActions];
  for (int a = 0; a < action_count; ++a) {
    out.states.push_back({moves.end_x[a], moves.end_y[a], moves.end_direction_x[a],
                          moves.end_direction_y[a], moves.speed[a]});
    uppers[a] = upper_bound_.value(out.states.back());
  }

  out.branches.resize(static_cast<size_t>(action_count) * count);
  ScenarioOutcome outcome;
  for (int i = 0; i < count; ++i) {
    const int scenario = scenarios[i];
    const float start_sq =
        nearestSq(futures_.at(scenario, depth), futures_.personCount(), state.x, state.y);
    kernel_.evaluate(evaluation, moves, start_sq, scenario, depth, outcome, out.model_steps);
    addBeyondHorizon(outcome);
    const std::uint64_t observation = futures_.observation(scenario, depth + 1);
    for (int a = 0; a < action_count; ++a) {
      Branch& branch = out.branches[static_cast<size_t>(a) * count + i];
      branch.reward = outcome.reward[a];
      branch.terminal = outcome.terminal[a] != 0;
      branch.observation = observation;
      branch.upper = uppers[a];
      for (int p = 0; p < constants_.policy_count; ++p) {
        branch.lower[p] = branch.terminal ? 0.0F : outcome.values[p * kMaxActions + a];
      }
    }
  }
  out.model_steps += static_cast<long>(action_count) * count;
}

void CrowdModel::prepareMoves(const RobotState& state, const ActionSet& set,
                              ActionMoves& moves) const {
  const StepConstants& c = constants_;
  moves.count = static_cast<int>(set.actions.size());
  moves.robot = state;
  moves.here = lookUp(field_, state.x, state.y);
  moves.arrived = goalDistanceSq(c, state.x, state.y) <= c.goal_tolerance_sq;
  const float braked = std::max(0.0F, state.speed - c.brake_step);
  for (int a = 0; a < kMaxActions; ++a) {
    const bool follows = set.follows_prior[a] != 0;
    const bool brakes = set.brakes[a] != 0;
    const float changed = state.speed + set.speed_steps[a] * c.speed_step;
    moves.speed[a] = brakes ? braked : std::min(std::max(changed, 0.0F), c.max_speed);
    moves.brake_penalty[a] = brakes ? c.brake_penalty : 0.0F;
    const float turned_x =
        state.direction_x * set.turn_cos[a] - state.direction_y * set.turn_sin[a];
    const float turned_y =
        state.direction_x * set.turn_sin[a] + state.direction_y * set.turn_cos[a];
    moves.to_x[a] = follows ? moves.here.direction_x : turned_x;
    moves.to_y[a] = follows ? moves.here.direction_y : turned_y;
    moves.follows_prior[a] = set.follows_prior[a];
  }
}

void CrowdModel::addBeyondHorizon(ScenarioOutcome& outcome) const {
  const RolloutBatch& ends = outcome.rollouts;
  for (int i = 0; i < ends.count; ++i) {
    outcome.values[ends.origin[i]] +=
        ends.discount * beyondHorizon({ends.x[i], ends.y[i], 1.0F, 0.0F, ends.speed[i]});
  }
}

void CrowdModel::rootBounds(const RobotState* states, const int* scenarios, int count,
                            double& lower, double& upper) const {
  const RobotState& state = states[0];
  const FieldLanes<float> here = lookUp(field_, state.x, state.y);
  double values[kDefaultPolicies] = {0.0, 0.0};
  const int policies = constants_.policy_count;
  for (int i = 0; i < count; ++i) {
    const float start_sq =
        nearestSq(futures_.at(scenarios[i], 0), futures_.personCount(), state.x, state.y);
    for (int p = 0; p < policies; ++p) {
      values[p] += rollOutOne(state, here, start_sq, scenarios[i], 0, p);
    }
  }
  lower = *std::max_element(values, values + policies) / count;
  upper = upper_bound_.value(state);
}

float CrowdModel::rollOutOne(const RobotState& state, const FieldLanes<float>& here, float start_sq,
                             int scenario, int depth, int policy) const {
  RolloutBatch batch;
  batch.start(depth);
  addRollout(
      {{state.x, state.y, state.direction_x, state.direction_y, state.speed}, here, start_sq},
      constants_.rules[policy], 0, batch);
  float value = 0.0F;
  long steps = 0;
  const RolloutTable table{constants_, field_, futures_, scenario};
  constants_.isUsual() ? rollOut<float, kHalfWay>(table, batch, &value, steps)
                       : rollOut<float, kMaxVias>(table, batch, &value, steps);
  if (batch.count == 0) return value;
  return value +
         batch.discount * beyondHorizon({batch.x[0], batch.y[0], 1.0F, 0.0F, batch.speed[0]});
}

template <int kVias>
MoveLanes<float, kVias> CrowdModel::moveOne(const RobotState& state, const Action& action) const {
  const RobotLanes<float> robot{state.x, state.y, state.direction_x, state.direction_y,
                                state.speed};
  const FieldLanes<float> here = lookUp(field_, state.x, state.y);
  const bool follows = action.heading == Action::Heading::kFollowPrior;
  const float cosine = std::cos(action.turn);
  const float sine = std::sin(action.turn);
  return moveRobots<float, kVias>(
      constants_, field_, robot, here, speedAfter(state, action),
      follows ? here.direction_x : state.direction_x * cosine - state.direction_y * sine,
      follows ? here.direction_y : state.direction_x * sine + state.direction_y * cosine, follows);
}

RobotState CrowdModel::move(const RobotState& state, const Action& action) const {
  const RobotLanes<float> end = constants_.isUsual() ? moveOne<kHalfWay>(state, action).end
                                                     : moveOne<kMaxVias>(state, action).end;
  return {end.x, end.y, end.direction_x, end.direction_y, end.speed};
}

Branch CrowdModel::step(const RobotState& state, int scenario, int depth, const Action& action,
                        RobotState& next) const {
  return constants_.isUsual() ? stepBy<kHalfWay>(state, scenario, depth, action, next)
                              : stepBy<kMaxVias>(state, scenario, depth, action, next);
}

template <int kVias>
Branch CrowdModel::stepBy(const RobotState& state, int scenario, int depth, const Action& action,
                          RobotState& next) const {
  const StepConstants& c = constants_;
  const MoveLanes<float, kVias> move = moveOne<kVias>(state, action);
  const RobotLanes<float> robot{state.x, state.y, state.direction_x, state.direction_y,
                                state.speed};
  float via_sq = kFarAwaySq;
  float end_sq = kFarAwaySq;
  meetPeople(c, move, futures_.at(scenario, depth), futures_.at(scenario, depth + 1),
             futures_.personCount(), via_sq, end_sq);
  const float start_sq =
      nearestSq(futures_.at(scenario, depth), futures_.personCount(), state.x, state.y);
  bool collides = false;
  const float penalty = collisionPenalty(c, robot, move, start_sq, via_sq, end_sq, collides);
  const bool arrived = goalDistanceSq(c, robot.x, robot.y) <= c.goal_tolerance_sq;
  next = {move.end.x, move.end.y, move.end.direction_x, move.end.direction_y, move.end.speed};

  Branch branch;
  branch.reward = stepCost(c, robot.speed) + (action.sudden_brake ? c.brake_penalty : 0.0F) +
                  (arrived ? c.goal_reward : penalty);
  branch.terminal = arrived || collides;
  branch.observation = futures_.observation(scenario, depth + 1);
  if (branch.terminal) return branch;
  for (int p = 0; p < c.policy_count; ++p) {
    branch.lower[p] = rollOutOne(next, move.field, end_sq, scenario, depth + 1, p);
  }
  branch.upper = upper_bound_.value(next);
  return branch;
}

// A free drive from here along the prior's path, speeding up as fast as possible.
float CrowdModel::beyondHorizon(const RobotState& state) const {
  if (params_.beyond_horizon == BeyondHorizon::kNothing) return 0.0F;
  return upper_bound_.value(state, field_.at(state.x, state.y).distance_to_goal);
}

Action CrowdModel::defaultAction(const RobotState* state) const {
  float start_sq = kFarAwaySq;
  for (int k = 0; k < std::min(1, futures_.scenarioCount()); ++k) {
    start_sq = nearestSq(futures_.at(k, 0), futures_.personCount(), state->x, state->y);
  }
  const bool moving = state->speed > 0.0F;
  const NavigationCell here = field_.at(state->x, state->y);
  const bool has_way = here.direction_x != 0.0F || here.direction_y != 0.0F;
  if (start_sq < constants_.rules[0].near_sq || !has_way)
    return Action::turnBy(0.0, moving ? -1 : 0);
  if (canFollowPrior(*state)) return Action::followPrior(moving ? 0 : 1);
  return Action::turnBy(std::copysign(M_PI / 4.0, angleToPrior(*state)), moving ? 0 : 1);
}

}  // namespace pomdp_crowd_nav
