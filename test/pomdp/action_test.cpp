// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/pomdp/action.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace pomdp_crowd_nav {
namespace {

std::vector<std::string> names(const std::vector<Action>& actions) {
  std::vector<std::string> names;
  for (const Action& action : actions) names.push_back(describe(action));
  return names;
}

const std::vector<std::string> kAtRest{
    "follow prior, speed +1", "turn +0 deg, speed +1",  "turn +15 deg, speed +1",
    "turn -15 deg, speed +1", "turn +30 deg, speed +1", "turn -30 deg, speed +1",
    "turn +45 deg, speed +1", "turn -45 deg, speed +1", "turn +0 deg, speed +0"};
const std::vector<std::string> kMoving{"follow prior, speed +0",
                                       "turn +0 deg, speed +1",
                                       "turn +0 deg, speed +0",
                                       "turn +15 deg, speed +0",
                                       "turn -15 deg, speed +0",
                                       "turn +30 deg, speed +0",
                                       "turn -30 deg, speed +0",
                                       "turn +45 deg, speed +0",
                                       "turn -45 deg, speed +0",
                                       "turn +0 deg, speed -1",
                                       "sudden brake"};

// The first of equally good actions is taken, so the order is part of the planner.
TEST(ActionSets, AreThePapersInTheOrderOfTies) {
  const ActionSets sets;
  EXPECT_EQ(names(sets.legal(false, true).actions), kAtRest);
  EXPECT_EQ(names(sets.legal(true, true).actions), kMoving);
}

TEST(ActionSets, WithoutAWayThePriorIsNotFollowed) {
  const ActionSets sets;
  EXPECT_EQ(names(sets.legal(false, false).actions),
            std::vector<std::string>(kAtRest.begin() + 1, kAtRest.end()));
  EXPECT_EQ(names(sets.legal(true, false).actions),
            std::vector<std::string>(kMoving.begin() + 1, kMoving.end()));
}

TEST(ActionSets, FitTheVectorLanes) {
  const ActionSets sets;
  for (const bool moving : {false, true}) {
    for (const bool has_way : {false, true}) {
      EXPECT_LE(sets.legal(moving, has_way).actions.size(), static_cast<size_t>(kMaxActions));
    }
  }
}

TEST(ActionSets, SayWhatAStepMultipliesWith) {
  const ActionSets sets;
  const ActionSet& set = sets.legal(true, true);
  for (int a = 0; a < kMaxActions; ++a) {
    const Action& action = set.actions[std::min(static_cast<size_t>(a), set.actions.size() - 1)];
    EXPECT_NEAR(set.turn_cos[a], std::cos(static_cast<double>(action.turn)), 1e-7);
    EXPECT_NEAR(set.turn_sin[a], std::sin(static_cast<double>(action.turn)), 1e-7);
    EXPECT_EQ(set.speed_steps[a], static_cast<float>(action.speed_steps));
    EXPECT_EQ(set.follows_prior[a], a == 0 ? -1 : 0);
    EXPECT_EQ(set.brakes[a], a >= 10 ? -1 : 0) << "the last is repeated";
  }
}

TEST(Action, IsSmall) {
  EXPECT_LE(sizeof(Action), 8U);
  const Action action = Action::turnBy(-M_PI / 6.0, 1);
  EXPECT_FLOAT_EQ(action.turn, static_cast<float>(-M_PI / 6.0));
  EXPECT_EQ(action.speed_steps, 1);
  EXPECT_FALSE(action.sudden_brake);
}

TEST(Action, DiffersInAnyPart) {
  EXPECT_EQ(Action::turnBy(0.5, 1), Action::turnBy(0.5, 1));
  EXPECT_NE(Action::turnBy(0.5, 1), Action::turnBy(0.5, 0));
  EXPECT_NE(Action::turnBy(0.5, 1), Action::turnBy(-0.5, 1));
  EXPECT_NE(Action::turnBy(0.0, 0), Action::followPrior(0));
  EXPECT_NE(Action::turnBy(0.0, 0), Action::suddenBrake());
}

}  // namespace
}  // namespace pomdp_crowd_nav
