// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/despot/exogenous_table.h"

#include <gtest/gtest.h>

#include "models/corridor.h"
#include "models/tiger.h"
#include "pomdp_crowd_nav/despot/search.h"

namespace pomdp_crowd_nav {
namespace {

// A random walk on the integers.
int first(int scenario, const NoiseStreams&) { return 100 * scenario; }
int next(int value, int scenario, int depth, const NoiseStreams& noise) {
  return value + (noise.uniform(scenario, depth, 0) < 0.5 ? 1 : -1);
}

TEST(ExogenousTable, FollowsItsRuleFromScenarioToScenario) {
  ExogenousTable<int> table;
  const NoiseStreams noise(7);
  table.draw(5, 30, noise, first, next);
  for (int k = 0; k < 5; ++k) {
    int value = 100 * k;
    EXPECT_EQ(table.at(k, 0), value);
    for (int d = 1; d <= 30; ++d) {
      value = next(value, k, d, noise);
      ASSERT_EQ(table.at(k, d), value);
    }
  }
}

TEST(ExogenousTable, AScenarioIsTheSameInTablesOfAnySize) {
  ExogenousTable<int> small;
  ExogenousTable<int> large;
  large.draw(50, 60, NoiseStreams(7), first, next);
  small.draw(60, 80, NoiseStreams(8), first, next);
  small.draw(5, 10, NoiseStreams(7), first, next);
  for (int k = 0; k < 5; ++k) {
    for (int d = 0; d <= 10; ++d) ASSERT_EQ(small.at(k, d), large.at(k, d));
  }
}

// Counts how often the search asks it to draw.
class DrawnCorridor : public Corridor {
 public:
  using Corridor::Corridor;
  void expand(const State* states, const int* scenarios, int count, int depth,
              Expansion<DrawnCorridor>& out) const {
    expandOneByOne(*this, states, scenarios, count, depth, out);
  }
  void drawExogenous(int scenarios, int depth) {
    ++draws;
    scenarios_drawn = scenarios;
    depth_drawn = depth;
  }
  int draws = 0;
  int scenarios_drawn = 0;
  int depth_drawn = 0;
};

TEST(ExogenousTable, IsDrawnOncePerSearch) {
  SearchParams params;
  params.scenarios = 20;
  params.max_depth = 5;
  params.discount = 0.9;
  DrawnCorridor model{Corridor::Params()};
  Search<DrawnCorridor> search(params);
  search.run(model, {{0}}, SearchLimit::trials(30));
  EXPECT_EQ(model.draws, 1);
  EXPECT_EQ(model.scenarios_drawn, 20);
  EXPECT_EQ(model.depth_drawn, 5);
  search.run(model, {{0}}, SearchLimit::trials(30));
  EXPECT_EQ(model.draws, 2);
  static_assert(HasExogenous<DrawnCorridor>::value, "it has the function");
  static_assert(!HasExogenous<Tiger>::value, "it has not");
}

}  // namespace
}  // namespace pomdp_crowd_nav
