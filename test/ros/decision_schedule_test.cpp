// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/ros/decision_schedule.h"

#include <gtest/gtest.h>

namespace pomdp_crowd_nav {
namespace {

TEST(DecisionSchedule, DecisionsFollowAtEvenSteps) {
  DecisionSchedule schedule(0.5, 0.3);
  schedule.restart(100.0);
  const DecisionSlot first = schedule.next(100.0);
  EXPECT_GE(first.start, 100.0);
  EXPECT_NEAR(first.deadline - first.start, 0.3, 1e-9);
  EXPECT_NEAR(first.effect - first.deadline, DecisionSchedule::kMargin, 1e-9);
  const DecisionSlot second = schedule.next(first.effect);
  EXPECT_NEAR(second.effect - first.effect, 0.5, 1e-9);
}

TEST(DecisionSchedule, SearchThatDoesNotFitIsShortened) {
  DecisionSchedule schedule(0.5, 2.0);
  EXPECT_LT(schedule.searchTime(), 0.5 - 2.0 * DecisionSchedule::kMargin + 1e-9);
  schedule.restart(0.0);
  const double effect = schedule.next(0.0).effect;
  EXPECT_GE(schedule.next(effect).start, effect);
}

TEST(DecisionSchedule, SlotsThatWereSleptThroughAreLeftOut) {
  DecisionSchedule schedule(0.5, 0.3);
  schedule.restart(100.0);
  const double first = schedule.next(100.0).effect;
  const DecisionSlot slot = schedule.next(first + 1.7);
  EXPECT_GE(slot.start, first + 1.7 - DecisionSchedule::kMargin);
  const double steps = (slot.effect - first) / 0.5;
  EXPECT_NEAR(steps, static_cast<int>(steps + 0.5), 1e-9) << "the grid of steps is kept";
  EXPECT_EQ(slot.left_out, static_cast<int>(steps + 0.5) - 1);
  EXPECT_EQ(schedule.next(slot.effect).left_out, 0);
}

TEST(DecisionSchedule, AShorterSearchBeginsWithTheNextDecision) {
  DecisionSchedule schedule(0.5, 0.3);
  schedule.restart(100.0);
  const double first = schedule.next(100.0).effect;
  schedule.setSearchTime(0.1);
  const DecisionSlot slot = schedule.next(first);
  EXPECT_NEAR(slot.deadline - slot.start, 0.1, 1e-9);
  EXPECT_NEAR(slot.effect - first, 0.5, 1e-9);
}

TEST(DecisionSchedule, ALongerSearchLeavesNoDecisionOut) {
  DecisionSchedule schedule(0.5, 0.1);
  schedule.restart(100.0);
  const double first = schedule.next(100.0).effect;
  schedule.setSearchTime(2.0);
  const double just_in_time = first + 0.5 - 0.15;
  const DecisionSlot second = schedule.next(just_in_time);
  EXPECT_EQ(second.left_out, 0);
  EXPECT_NEAR(second.effect - first, 0.5, 1e-9);
  const DecisionSlot third = schedule.next(second.effect);
  EXPECT_EQ(third.left_out, 0);
  EXPECT_NEAR(third.deadline - third.start, 0.5 - 3.0 * DecisionSchedule::kMargin, 1e-9);
}

}  // namespace
}  // namespace pomdp_crowd_nav
