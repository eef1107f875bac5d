// SPDX-License-Identifier: BSD-3-Clause
// The body of lane_kernel_*.cpp, included once for each vector width: no include guard, and
// PCN_KERNEL and PCN_KERNEL_NAME are the includer's.

namespace pomdp_crowd_nav {
namespace {

void moveActions(const Evaluation& e, const Lanes& speed, const Lanes& to_x, const Lanes& to_y,
                 const LaneMask& follows_prior, const FieldLanes<Lanes>& here, ActionLanes& lanes) {
  lanes.move =
      moveRobots<Lanes>(e.constants, e.field, lanes.robot, here, speed, to_x, to_y, follows_prior);
  lanes.arrived =
      goalDistanceSq(e.constants, lanes.robot.x, lanes.robot.y) <= e.constants.goal_tolerance_sq;
}

void evaluateScenario(const Evaluation& e, const ActionLanes& lanes, float start_sq, int scenario,
                      int depth, ScenarioOutcome& out, long& steps) {
  const StepConstants& c = e.constants;
  Lanes mid_sq = spread<Lanes>(std::numeric_limits<float>::max());
  Lanes end_sq = mid_sq;
  meetPeople(lanes.move, e.futures.at(scenario, depth), e.futures.at(scenario, depth + 1),
             e.futures.personCount(), mid_sq, end_sq);
  LaneMask collides;
  const Lanes penalty = collisionPenalty(c, lanes.robot, lanes.move, spread<Lanes>(start_sq),
                                         mid_sq, end_sq, collides);
  out.reward = stepCost(c, lanes.robot.speed) + lanes.brake_penalty +
               select(lanes.arrived, spread<Lanes>(c.goal_reward), penalty);
  out.terminal = lanes.arrived | collides;

  for (int p = 0; p < (c.has_bold ? 2 : 1); ++p) {
    RolloutStart<Lanes> start{lanes.move.end, lanes.move.field, end_sq,
                              lanes.used & (out.terminal == 0)};
    ScenarioOutcome::Rollouts& rollouts = out.rollouts[p];
    rollouts.value = rollOut<Lanes>(c, p == 0 ? c.reactive : c.bold, e.field, e.futures, scenario,
                                    depth + 1, start, rollouts.discount, steps);
    rollouts.horizon = start.robot;
    rollouts.reached_horizon = start.alive;
  }
}

}  // namespace

extern const LaneKernel PCN_KERNEL;
const LaneKernel PCN_KERNEL{PCN_KERNEL_NAME, moveActions, evaluateScenario};

}  // namespace pomdp_crowd_nav
