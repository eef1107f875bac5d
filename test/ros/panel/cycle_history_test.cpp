// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/ros/panel/cycle_history.h"

#include <gtest/gtest.h>

#include <cmath>

namespace pomdp_crowd_nav {
namespace {

TEST(CycleHistory, CountsEveryDecisionOnce) {
  CycleHistory history;
  history.add(0, 0.0);  // no decision yet
  history.add(1, 0.3);
  history.add(1, 0.3);  // a status between decisions
  history.add(2, 0.3);
  history.add(1, 0.4);  // another trip
  EXPECT_EQ(history.times(), (std::deque<double>{0.3, 0.3, 0.4}));
}

TEST(CycleHistory, KeepsTheNewest) {
  CycleHistory history;
  for (unsigned i = 1; i <= 100; ++i) history.add(i, i);
  ASSERT_EQ(history.times().size(), CycleHistory::kMost);
  EXPECT_EQ(history.times().back(), 100.0);
}

TEST(CycleHistory, LeavesOutWhatIsNoTime) {
  CycleHistory history;
  history.add(1, NAN);
  history.add(2, -1.0);
  history.add(3, INFINITY);
  EXPECT_TRUE(history.times().empty());
}

TEST(CycleBars, StandAtTheRightAndLateOnesAreOverTheLine) {
  CycleHistory history;
  history.add(1, 0.2);
  history.add(2, 0.44);
  const CycleBars bars = barsOf(history, 0.4, 120.0, 100.0);
  ASSERT_EQ(bars.bars.size(), 2u);
  EXPECT_DOUBLE_EQ(bars.width, 2.0);
  EXPECT_DOUBLE_EQ(bars.bars[1].left, 118.0);
  EXPECT_DOUBLE_EQ(*bars.deadline_top, 20.0);  // the top of the box is a quarter over it
  EXPECT_DOUBLE_EQ(bars.bars[0].top, 60.0);
  EXPECT_LT(bars.bars[1].top, *bars.deadline_top);
  EXPECT_FALSE(bars.bars[0].is_late);
  EXPECT_TRUE(bars.bars[1].is_late);
}

TEST(CycleBars, TheLongestFitsIntoTheBox) {
  CycleHistory history;
  history.add(1, 0.2);
  history.add(2, 3.0);
  const CycleBars bars = barsOf(history, 0.4, 120.0, 100.0);
  EXPECT_DOUBLE_EQ(bars.bars[1].top, 0.0);
  EXPECT_NEAR(bars.bars[0].top, 100.0 * (1.0 - 0.2 / 3.0), 1e-9);
}

TEST(CycleBars, AShortDecisionIsSeenToo) {
  CycleHistory history;
  history.add(1, 0.0);
  EXPECT_DOUBLE_EQ(barsOf(history, 0.4, 120.0, 100.0).bars.at(0).top, 99.0);
}

TEST(CycleBars, NothingIsLateWithoutADeadline) {
  CycleHistory history;
  EXPECT_TRUE(barsOf(history, std::nullopt, 120.0, 100.0).bars.empty());
  history.add(1, 9.0);
  const CycleBars bars = barsOf(history, std::nullopt, 120.0, 100.0);
  EXPECT_FALSE(bars.deadline_top);
  EXPECT_FALSE(bars.bars.at(0).is_late);
}

}  // namespace
}  // namespace pomdp_crowd_nav
