// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/planner/planner.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <stdexcept>

namespace pomdp_crowd_nav {
namespace {

std::string messageFor(const std::function<void(PlannerParams&)>& change) {
  PlannerParams params;
  change(params);
  try {
    validate(params);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "accepted";
}

TEST(PlannerParams, DefaultsAreValid) { EXPECT_NO_THROW(validate(PlannerParams())); }

TEST(PlannerParams, NamesTheFieldThatIsOutOfRange) {
  EXPECT_EQ(messageFor([](PlannerParams& p) { p.pedestrians = -1; }),
            "attended_pedestrians must be between 0 and 64, got -1");
  EXPECT_EQ(messageFor([](PlannerParams& p) { p.pedestrians = 65; }),
            "attended_pedestrians must be between 0 and 64, got 65");
  EXPECT_EQ(messageFor([](PlannerParams& p) { p.attention_lookahead = -0.5; }),
            "attention_lookahead must be in [0, 10] s, got -0.5");
  EXPECT_EQ(messageFor([](PlannerParams& p) { p.attention_angle = -0.5; }),
            "attention_angle must be in (0, pi] rad, got -0.5");
  EXPECT_EQ(messageFor([](PlannerParams& p) { p.attention_angle = 6.5; }),
            "attention_angle must be in (0, pi] rad, got 6.5");
  EXPECT_EQ(messageFor([](PlannerParams& p) { p.search.scenarios = 0; }),
            "search/scenarios must be between 1 and 65535, got 0");
  EXPECT_EQ(messageFor([](PlannerParams& p) { p.model.goal_tolerance = -0.5; }),
            "xy_goal_tolerance must be positive, got -0.5");
  EXPECT_NE(messageFor([](PlannerParams& p) { p.attention_angle = std::nan(""); }), "accepted");
  EXPECT_NE(messageFor([](PlannerParams& p) { p.attention_lookahead = std::nan(""); }), "accepted");
}

}  // namespace
}  // namespace pomdp_crowd_nav
