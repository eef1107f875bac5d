// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/pomdp/action.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pomdp_crowd_nav {
namespace {

double radians(double degrees) { return degrees * M_PI / 180.0; }

// The search takes the first of equally good actions: the direct way, then the smaller turn.
std::vector<Action> actionsAtRest() {
  return {Action::followPrior(1),         Action::turnBy(0.0, 1),
          Action::turnBy(radians(15), 1), Action::turnBy(radians(-15), 1),
          Action::turnBy(radians(30), 1), Action::turnBy(radians(-30), 1),
          Action::turnBy(radians(45), 1), Action::turnBy(radians(-45), 1),
          Action::turnBy(0.0, 0)};
}

std::vector<Action> actionsMoving() {
  return {Action::followPrior(0),
          Action::turnBy(0.0, 1),
          Action::turnBy(0.0, 0),
          Action::turnBy(radians(15), 0),
          Action::turnBy(radians(-15), 0),
          Action::turnBy(radians(30), 0),
          Action::turnBy(radians(-30), 0),
          Action::turnBy(radians(45), 0),
          Action::turnBy(radians(-45), 0),
          Action::turnBy(0.0, -1),
          Action::suddenBrake()};
}

std::vector<Action> withoutPrior(const std::vector<Action>& actions) {
  std::vector<Action> rest;
  for (const Action& action : actions) {
    if (action.heading != Action::Heading::kFollowPrior) rest.push_back(action);
  }
  return rest;
}

}  // namespace

Action Action::turnBy(double angle, int speed_steps) {
  Action action;
  action.turn = static_cast<float>(angle);
  action.speed_steps = static_cast<std::int8_t>(speed_steps);
  return action;
}

Action Action::followPrior(int speed_steps) {
  Action action;
  action.heading = Heading::kFollowPrior;
  action.speed_steps = static_cast<std::int8_t>(speed_steps);
  return action;
}

Action Action::suddenBrake() {
  Action action;
  action.sudden_brake = true;
  return action;
}

bool Action::operator==(const Action& other) const {
  return heading == other.heading && turn == other.turn && speed_steps == other.speed_steps &&
         sudden_brake == other.sudden_brake;
}

std::string describe(const Action& action) {
  if (action.sudden_brake) return "sudden brake";
  if (action.heading == Action::Heading::kFollowPrior) {
    return fmt::format("follow prior, speed {:+d}", static_cast<int>(action.speed_steps));
  }
  return fmt::format("turn {:+.0f} deg, speed {:+d}", action.turn * 180.0 / M_PI,
                     static_cast<int>(action.speed_steps));
}

ActionSet::ActionSet(std::vector<Action> some) : actions(std::move(some)) {
  for (int a = 0; a < kMaxActions; ++a) {
    const Action& action = actions[std::min(static_cast<size_t>(a), actions.size() - 1)];
    turn_cos[a] = std::cos(action.turn);
    turn_sin[a] = std::sin(action.turn);
    speed_steps[a] = static_cast<float>(action.speed_steps);
    follows_prior[a] = action.heading == Action::Heading::kFollowPrior ? -1 : 0;
    brakes[a] = action.sudden_brake ? -1 : 0;
  }
}

ActionSets::ActionSets()
    : sets_{ActionSet(withoutPrior(actionsAtRest())), ActionSet(actionsAtRest()),
            ActionSet(withoutPrior(actionsMoving())), ActionSet(actionsMoving())} {}

}  // namespace pomdp_crowd_nav
