// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/pomdp/model_params.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <stdexcept>
#include <string>

namespace pomdp_crowd_nav {
namespace {

std::string messageFor(const std::function<void(ModelParams&)>& change) {
  ModelParams params;
  change(params);
  try {
    validate(params);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "accepted";
}

TEST(ModelParams, DefaultsAreThePapers) {
  const ModelParams params;
  EXPECT_NO_THROW(validate(params));
  EXPECT_EQ(params.depth(), 100);
  EXPECT_DOUBLE_EQ(params.discount(), 0.97);
  EXPECT_DOUBLE_EQ(params.speedStep(), 1.0);
  EXPECT_DOUBLE_EQ(params.pedestrianClearance(), 2.0);
  EXPECT_DOUBLE_EQ(params.obstacleClearance(), 3.0);
}

TEST(ModelParams, AShorterPeriodKeepsDiscountAndHorizonInSeconds) {
  ModelParams params;
  params.step = 0.4;
  params.horizon = 24.0;
  EXPECT_EQ(params.depth(), 60);
  EXPECT_NEAR(std::pow(params.discount(), 2.5), 0.97, 1e-12);
  EXPECT_DOUBLE_EQ(params.speedStep(), 0.4);
  params.horizon = 24.1;
  EXPECT_EQ(params.depth(), 61) << "the horizon is covered";
  params.step = 1.0 / 3.0;
  params.horizon = 10.0;
  EXPECT_EQ(params.depth(), 30) << "rounding adds no step";
}

TEST(ModelParams, NamesTheFieldThatIsOutOfRange) {
  EXPECT_EQ(messageFor([](ModelParams& p) { p.step = -0.5; }),
            "decision period (1 / planner_frequency) must be in (0, 10] s, got -0.5");
  EXPECT_EQ(messageFor([](ModelParams& p) { p.horizon = 0.5; }),
            "horizon must be between 1 and 2000 steps, got 0.5");
  EXPECT_EQ(messageFor([](ModelParams& p) { p.horizon = 2000.5; }),
            "horizon must be between 1 and 2000 steps, got 2000.5");
  EXPECT_EQ(messageFor([](ModelParams& p) { p.discount_per_second = 1.2; }),
            "discount must be in (0, 1), got 1.2");
  EXPECT_EQ(messageFor([](ModelParams& p) { p.goal_tolerance = -0.1; }),
            "xy_goal_tolerance must be positive, got -0.1");
  EXPECT_EQ(messageFor([](ModelParams& p) { p.pedestrian_distance = -0.1; }),
            "pedestrian_distance must be at least 0, got -0.1");
  EXPECT_EQ(messageFor([](ModelParams& p) { p.obstacle_distance = -0.1; }),
            "obstacle_distance must be at least 0, got -0.1");
  EXPECT_EQ(messageFor([](ModelParams& p) { p.collision_checks = 1; }),
            "collision_checks must be between 2 and 10, got 1");
  EXPECT_EQ(messageFor([](ModelParams& p) { p.collision_checks = 11; }),
            "collision_checks must be between 2 and 10, got 11");
  EXPECT_EQ(messageFor([](ModelParams& p) { p.near_distance = -0.1; }),
            "near_distance must be at least 0, got -0.1");
  EXPECT_EQ(messageFor([](ModelParams& p) { p.far_distance = 3.5; }),
            "far_distance must be at least near_distance, got 3.5");
  EXPECT_EQ(messageFor([](ModelParams& p) { p.bold_distance = -0.5; }),
            "bold_distance must be at least 0, got -0.5");
  EXPECT_EQ(messageFor([](ModelParams& p) { p.pedestrian_noise = -0.1; }),
            "pedestrian_noise must be at least 0, got -0.1");
  EXPECT_EQ(messageFor([](ModelParams& p) { p.vehicle.radius = -0.5; }),
            "robot_radius must be positive, got -0.5");
}

TEST(ModelParams, GoalsArePositiveAndCostsNegative) {
  EXPECT_EQ(messageFor([](ModelParams& p) { p.reward.goal = -0.5; }),
            "reward/goal must be positive, got -0.5");
  EXPECT_EQ(messageFor([](ModelParams& p) { p.reward.pedestrian = 0.5; }),
            "reward/pedestrian must be at most 0, got 0.5");
  EXPECT_EQ(messageFor([](ModelParams& p) { p.reward.obstacle = 0.5; }),
            "reward/obstacle must be at most 0, got 0.5");
  EXPECT_EQ(messageFor([](ModelParams& p) { p.reward.sudden_brake = 0.5; }),
            "reward/sudden_brake must be at most 0, got 0.5");
  EXPECT_EQ(messageFor([](ModelParams& p) { p.reward.time = 0.5; }),
            "reward/time must be at most 0, got 0.5");
  EXPECT_EQ(messageFor([](ModelParams& p) { p.reward.low_speed = 0.5; }),
            "reward/low_speed must be at most 0, got 0.5");
}

TEST(ModelParams, NanIsOutOfRange) {
  const double nan = std::nan("");
  for (double ModelParams::*field :
       {&ModelParams::step, &ModelParams::horizon, &ModelParams::discount_per_second,
        &ModelParams::goal_tolerance, &ModelParams::pedestrian_distance,
        &ModelParams::obstacle_distance, &ModelParams::near_distance, &ModelParams::far_distance,
        &ModelParams::bold_distance, &ModelParams::pedestrian_noise}) {
    EXPECT_NE(messageFor([&](ModelParams& p) { p.*field = nan; }), "accepted");
  }
}

}  // namespace
}  // namespace pomdp_crowd_nav
