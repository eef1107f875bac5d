// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/params/param_values.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace pomdp_crowd_nav {
namespace {

std::string refusal(const ParamValues& values) {
  try {
    return withValues(NavigationParams(), values), "accepted";
  } catch (const std::exception& error) {
    return error.what();
  }
}

TEST(ParamValues, AreThoseOfTheFields) {
  NavigationParams params;
  params.search_time = 0.17;
  params.planning.model.reward.goal = 321.0;
  params.planning.model.beyond_horizon = BeyondHorizon::kFreeDrive;
  params.planning.search.scenarios = 77;
  const ParamValues values = valuesOf(params);
  EXPECT_EQ(std::get<double>(values.at("search_time")), 0.17);
  EXPECT_EQ(std::get<double>(values.at("reward/goal")), 321.0);
  EXPECT_EQ(std::get<int>(values.at("search/scenarios")), 77);
  EXPECT_EQ(std::get<bool>(values.at("emergency/enabled")), true);
  EXPECT_EQ(std::get<std::string>(values.at("planner")), "2d_fmm");
  EXPECT_EQ(std::get<std::string>(values.at("model/beyond_horizon")), "free_drive");
}

TEST(ParamValues, ReplaceOnlyWhatTheyName) {
  NavigationParams params;
  params.planning.model.step = 0.3;  // whose inverse has no exact inverse
  const NavigationParams changed = withValues(
      params, {{"reward/goal", 500.0}, {"search/scenarios", 50}, {"model/bold_rollouts", false}});
  EXPECT_EQ(changed.planning.model.reward.goal, 500.0);
  EXPECT_EQ(changed.planning.search.scenarios, 50);
  EXPECT_FALSE(changed.planning.model.bold_rollouts);
  EXPECT_EQ(changed.planning.model.step, 0.3);
  EXPECT_EQ(changedKeys(params, changed),
            (std::vector<std::string>{"model/bold_rollouts", "reward/goal", "search/scenarios"}));
  EXPECT_TRUE(changedKeys(params, withValues(params, {})).empty());
}

TEST(ParamValues, ThatDoNotFitAreRefused) {
  EXPECT_EQ(refusal({{"reward/goall", 1.0}}),
            "new parameters: unknown key 'reward/goall', did you mean 'reward/goal'?");
  EXPECT_EQ(refusal({{"reward/goal", 5}}),
            "new parameters: reward/goal: expected a number, got '5'");
  EXPECT_EQ(refusal({{"model/far_distance", 2.5}}),
            "far_distance must be at least near_distance, got 2.5");
  EXPECT_NE(refusal({{"search_time", 20.0}}).find("search_time must be between"),
            std::string::npos);
  EXPECT_NE(refusal({{"planner", std::string("2d_nhv")}}).find("for vehicle 'holonomic'"),
            std::string::npos);
  for (const char* key : {"reward/goal", "emergency/reflex_distance", "prior/extra_clearance"}) {
    EXPECT_NE(refusal({{key, std::nan("")}}), "accepted") << key;
  }
}

}  // namespace
}  // namespace pomdp_crowd_nav
