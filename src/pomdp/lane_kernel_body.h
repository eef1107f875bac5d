// SPDX-License-Identifier: BSD-3-Clause
// The body of lane_kernel_*.cpp, included once for each vector width: no include guard; the
// includer defines PCN_KERNEL, PCN_KERNEL_NAME and PCN_VALUE, the vector type.

namespace pomdp_crowd_nav {
namespace {

using Value = PCN_VALUE;
using Mask = MaskOf<Value>::Type;

RobotLanes<Value> everywhere(const RobotState& robot) {
  return {spread<Value>(robot.x), spread<Value>(robot.y), spread<Value>(robot.direction_x),
          spread<Value>(robot.direction_y), spread<Value>(robot.speed)};
}

template <int kVias>
MoveLanes<Value, kVias> loadMove(const StepConstants& c, const ActionMoves& moves, int a) {
  MoveLanes<Value, kVias> move;
  move.end = {load<Value>(moves.end_x + a), load<Value>(moves.end_y + a),
              load<Value>(moves.end_direction_x + a), load<Value>(moves.end_direction_y + a),
              load<Value>(moves.speed + a)};
  for (int k = 0; k < viaCount<kVias>(c); ++k) {
    move.via_x[k] = load<Value>(moves.via_x[k] + a);
    move.via_y[k] = load<Value>(moves.via_y[k] + a);
  }
  move.field = {load<Value>(moves.field_direction_x + a), load<Value>(moves.field_direction_y + a),
                load<Value>(moves.field_clearance + a)};
  move.ends_outside = loadMask<Mask>(moves.ends_outside + a);
  move.hits_obstacle = loadMask<Mask>(moves.hits_obstacle + a);
  return move;
}

template <int kVias>
void storeMove(const StepConstants& c, const MoveLanes<Value, kVias>& move, int a,
               ActionMoves& moves) {
  store(move.end.x, moves.end_x + a);
  store(move.end.y, moves.end_y + a);
  store(move.end.direction_x, moves.end_direction_x + a);
  store(move.end.direction_y, moves.end_direction_y + a);
  for (int k = 0; k < viaCount<kVias>(c); ++k) {
    store(move.via_x[k], moves.via_x[k] + a);
    store(move.via_y[k], moves.via_y[k] + a);
  }
  store(move.field.direction_x, moves.field_direction_x + a);
  store(move.field.direction_y, moves.field_direction_y + a);
  store(move.field.clearance, moves.field_clearance + a);
  store(move.ends_outside, moves.ends_outside + a);
  store(move.hits_obstacle, moves.hits_obstacle + a);
}

template <int kVias>
void moveActionsBy(const Evaluation& e, ActionMoves& moves) {
  const RobotLanes<Value> robot = everywhere(moves.robot);
  const FieldLanes<Value> here{spread<Value>(moves.here.direction_x),
                               spread<Value>(moves.here.direction_y),
                               spread<Value>(moves.here.clearance)};
  for (int a = 0; a < moves.count; a += kLanesOf<Value>) {
    storeMove<kVias>(
        e.constants,
        moveRobots<Value, kVias>(e.constants, e.field, robot, here, load<Value>(moves.speed + a),
                                 load<Value>(moves.to_x + a), load<Value>(moves.to_y + a),
                                 loadMask<Mask>(moves.follows_prior + a)),
        a, moves);
  }
}

void moveActions(const Evaluation& e, ActionMoves& moves) {
  e.constants.isUsual() ? moveActionsBy<kHalfWay>(e, moves) : moveActionsBy<kMaxVias>(e, moves);
}

// The roll-outs of one scenario: from where every action ends that did not end it, under every
// policy. `nearest_sq` is to the nearest person there [m^2].
template <int kVias>
void rollOutActions(const Evaluation& e, const ActionMoves& moves, const float* nearest_sq,
                    int scenario, ScenarioOutcome& out, long& steps) {
  const StepConstants& c = e.constants;
  for (int p = 0; p < c.policy_count; ++p) {
    for (int a = 0; a < moves.count; ++a) {
      if (out.terminal[a] != 0) continue;
      addRollout(
          {{moves.end_x[a], moves.end_y[a], moves.end_direction_x[a], moves.end_direction_y[a],
            moves.speed[a]},
           {moves.field_direction_x[a], moves.field_direction_y[a], moves.field_clearance[a]},
           nearest_sq[a]},
          c.rules[p], p * kMaxActions + a, out.rollouts);
    }
  }
  rollOut<Value, kVias>({c, e.field, e.futures, scenario}, out.rollouts, out.values, steps);
}

template <int kVias>
void evaluateScenarioBy(const Evaluation& e, const ActionMoves& moves, float start_sq, int scenario,
                        int depth, ScenarioOutcome& out, long& steps) {
  const StepConstants& c = e.constants;
  const RobotLanes<Value> robot = everywhere(moves.robot);
  const Mask arrived = moves.arrived ? ~Mask{} : Mask{};
  alignas(64) ActionFloats nearest_sq;
  for (int a = 0; a < moves.count; a += kLanesOf<Value>) {
    const MoveLanes<Value, kVias> move = loadMove<kVias>(c, moves, a);
    Value via_sq = spread<Value>(kFarAwaySq);
    Value end_sq = via_sq;
    meetPeople(c, move, e.futures.at(scenario, depth), e.futures.at(scenario, depth + 1),
               e.futures.personCount(), via_sq, end_sq);
    Mask collides;
    const Value penalty =
        collisionPenalty(c, robot, move, spread<Value>(start_sq), via_sq, end_sq, collides);
    store(stepCost(c, robot.speed) + load<Value>(moves.brake_penalty + a) +
              select(arrived, spread<Value>(c.goal_reward), penalty),
          out.reward + a);
    store(arrived | collides, out.terminal + a);
    store(end_sq, nearest_sq + a);
  }
  out.rollouts.start(depth + 1);
  rollOutActions<kVias>(e, moves, nearest_sq, scenario, out, steps);
}

void evaluateScenario(const Evaluation& e, const ActionMoves& moves, float start_sq, int scenario,
                      int depth, ScenarioOutcome& out, long& steps) {
  const auto evaluate =
      e.constants.isUsual() ? evaluateScenarioBy<kHalfWay> : evaluateScenarioBy<kMaxVias>;
  evaluate(e, moves, start_sq, scenario, depth, out, steps);
}

}  // namespace

extern const LaneKernel PCN_KERNEL;
const LaneKernel PCN_KERNEL{PCN_KERNEL_NAME, moveActions, evaluateScenario};

}  // namespace pomdp_crowd_nav
