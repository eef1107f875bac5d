// SPDX-License-Identifier: BSD-3-Clause
#include "models/crossing.h"

#include <gtest/gtest.h>

#include "models/every_policy.h"

namespace pomdp_crowd_nav {
namespace {

TEST(Crossing, WalksUpToTheRoadFirst) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const auto result = cross(0, seed);
    EXPECT_EQ(result.action, Crossing::kGo);
    EXPECT_EQ(result.statistics.stop, SearchStop::kGapClosed);
    EXPECT_EQ(result.statistics.bound_violations, 0);
  }
}

// A car passes now with odds of a half, hence with 0.4 in the next step.
TEST(Crossing, LooksBeforeItCrosses) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) EXPECT_EQ(cross(1, seed).action, Crossing::kWait);
}

TEST(Crossing, IsWorthWhatTheBestOfAllPoliciesEarns) {
  SearchParams params;
  params.scenarios = 12;
  params.max_depth = 5;
  params.discount = Crossing::kGamma;
  params.regularization = 0.0;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    Crossing model(seed);
    Search<Crossing> search(params);
    const auto result = search.run(model, {0}, SearchLimit::trials(10000));
    const double optimum = EveryPolicy<Crossing>(model, params).optimum({0});
    EXPECT_NEAR(result.statistics.lower_bound, optimum, 1e-4) << seed;
  }
}

}  // namespace
}  // namespace pomdp_crowd_nav
