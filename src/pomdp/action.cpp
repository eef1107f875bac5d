// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/pomdp/action.h"

#include <fmt/format.h>

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
  action.turn_cos = static_cast<float>(std::cos(angle));
  action.turn_sin = static_cast<float>(std::sin(angle));
  action.speed_steps = speed_steps;
  return action;
}

Action Action::followPrior(int speed_steps) {
  Action action;
  action.heading = Heading::kFollowPrior;
  action.speed_steps = speed_steps;
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
    return fmt::format("follow prior, speed {:+d}", action.speed_steps);
  }
  return fmt::format("turn {:+.0f} deg, speed {:+d}", action.turn * 180.0 / M_PI,
                     action.speed_steps);
}

ActionSets::ActionSets() {
  sets_[1] = actionsAtRest();
  sets_[0] = withoutPrior(sets_[1]);
  sets_[3] = actionsMoving();
  sets_[2] = withoutPrior(sets_[3]);
}

}  // namespace pomdp_crowd_nav
