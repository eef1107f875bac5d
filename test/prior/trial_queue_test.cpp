// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/prior/trial_queue.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>
#include <vector>

namespace pomdp_crowd_nav {
namespace {

TEST(TrialQueueTest, GivesTheEarliestFirst) {
  TrialQueue queue;
  EXPECT_TRUE(queue.isEmpty());
  const std::vector<float> times{
      3.5F, 0.0F, 1e-40F, 2e9F, 0.25F, 1.0F, std::numeric_limits<float>::infinity()};
  for (size_t i = 0; i < times.size(); ++i) queue.push({times[i], static_cast<int>(i)});
  for (const int cell : {1, 2, 4, 5, 0, 3, 6}) {
    const TrialQueue::Trial earliest = queue.pop();
    EXPECT_EQ(earliest.cell, cell);
    EXPECT_EQ(earliest.time, times[static_cast<size_t>(cell)]);
  }
  EXPECT_TRUE(queue.isEmpty());
}

// Marches on symmetric maps are the same everywhere only if this order is.
TEST(TrialQueueTest, GivesEqualTimesInAnOrderOfItsOwn) {
  TrialQueue queue;
  std::vector<int> order;
  for (int cell = 0; cell < 7; ++cell) queue.push({1.0F, cell});
  for (int i = 0; i < 3; ++i) order.push_back(queue.pop().cell);
  for (int cell = 7; cell < 10; ++cell) queue.push({1.0F, cell});
  while (!queue.isEmpty()) order.push_back(queue.pop().cell);
  EXPECT_EQ(order, (std::vector<int>{0, 2, 5, 6, 4, 8, 9, 7, 1, 3}));
}

// As a march does: what is put in is no earlier than what was taken out last.
TEST(TrialQueueTest, LosesNothingAndGoesNeverBackOnALongMarch) {
  TrialQueue queue;
  std::mt19937 random(7);
  std::uniform_int_distribution<int> steps(0, 20);  // few, so that many are equal
  std::vector<int> seen;
  int pushed = 0;
  const auto push = [&](float from) {
    queue.push({from + 0.125F * static_cast<float>(steps(random)), pushed++});
  };
  for (int i = 0; i < 100; ++i) push(0.0F);
  float last = 0.0F;
  while (!queue.isEmpty()) {
    const TrialQueue::Trial earliest = queue.pop();
    ASSERT_GE(earliest.time, last);
    last = earliest.time;
    seen.push_back(earliest.cell);
    const int more = pushed < 5000 ? steps(random) % 3 : 0;
    for (int i = 0; i < more; ++i) push(last);
  }
  ASSERT_EQ(seen.size(), static_cast<size_t>(pushed));
  std::sort(seen.begin(), seen.end());
  for (int i = 0; i < pushed; ++i) ASSERT_EQ(seen[static_cast<size_t>(i)], i);
}

}  // namespace
}  // namespace pomdp_crowd_nav
