// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/despot/expansion.h"

#include <gtest/gtest.h>

#include "models/corridor.h"
#include "models/tiger.h"

namespace pomdp_crowd_nav {
namespace {

TEST(Expansion, HoldsBranchesActionByAction) {
  const Tiger tiger{Tiger::Params()};
  const std::vector<Tiger::State> states{Tiger::kTigerLeft, Tiger::kTigerRight};
  const std::vector<int> scenarios{0, 1};
  Expansion<Tiger> out;
  expandOneByOne(tiger, states.data(), scenarios.data(), 2, 0, out);
  ASSERT_EQ(out.actions.size(), 3U);
  ASSERT_EQ(out.branches.size(), 6U);
  EXPECT_EQ(out.states.size(), 6U) << "one next state for each branch";
  EXPECT_EQ(out.model_steps, 6);
  EXPECT_FALSE(out.branches[0].terminal);
  EXPECT_EQ(out.branches[2].reward, Tiger::kMauled);    // open left, tiger left
  EXPECT_EQ(out.branches[3].reward, Tiger::kTreasure);  // open left, tiger right
  EXPECT_TRUE(out.branches[5].terminal);
}

TEST(Expansion, HoldsOneStatePerActionWhereTheModelSharesThem) {
  const Corridor corridor{Corridor::Params()};
  const Corridor::State state{1};
  const std::vector<int> scenarios{4, 7, 9};
  Expansion<Corridor> out;
  expandOneByOne(corridor, &state, scenarios.data(), 3, 0, out);
  ASSERT_EQ(out.actions.size(), 3U);
  EXPECT_EQ(out.branches.size(), 9U);
  ASSERT_EQ(out.states.size(), 3U);
  EXPECT_EQ(out.states[0].cell, 1);
  EXPECT_EQ(out.states[1].cell, 2);
  EXPECT_EQ(out.states[2].cell, 0);
}

TEST(Expansion, StartsAnewEachTime) {
  const Tiger tiger{Tiger::Params()};
  const Tiger::State state = Tiger::kTigerLeft;
  const int scenario = 0;
  Expansion<Tiger> out;
  expandOneByOne(tiger, &state, &scenario, 1, 0, out);
  expandOneByOne(tiger, &state, &scenario, 1, 0, out);
  EXPECT_EQ(out.branches.size(), 3U);
  EXPECT_EQ(out.states.size(), 3U);
  EXPECT_EQ(out.model_steps, 3);
}

}  // namespace
}  // namespace pomdp_crowd_nav
