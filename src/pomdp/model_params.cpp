// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/pomdp/model_params.h"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

namespace pomdp_crowd_nav {
namespace {

void require(bool fits, const char* name, const char* expected, double value) {
  if (fits) return;
  throw std::invalid_argument(fmt::format("{} must be {}, got {}", name, expected, value));
}

}  // namespace

int ModelParams::depth() const { return static_cast<int>(std::ceil(horizon / step - 1e-9)); }

double ModelParams::discount() const { return std::pow(discount_per_second, step); }

void validate(const ModelParams& p) {
  validate(p.vehicle);
  require(p.step > 0.0 && p.step <= 10.0, "decision period (1 / planner_frequency)", "in (0, 10] s",
          p.step);
  require(p.horizon >= p.step && p.depth() <= 2000, "horizon", "between 1 and 2000 steps",
          p.horizon);
  require(p.discount_per_second > 0.0 && p.discount_per_second < 1.0, "discount", "in (0, 1)",
          p.discount_per_second);
  require(p.goal_tolerance > 0.0, "xy_goal_tolerance", "positive", p.goal_tolerance);
  require(p.pedestrian_distance >= 0.0, "pedestrian_distance", "at least 0", p.pedestrian_distance);
  require(p.obstacle_distance >= 0.0, "obstacle_distance", "at least 0", p.obstacle_distance);
  require(p.collision_checks >= 2 && p.collision_checks <= kMaxCollisionChecks, "collision_checks",
          "between 2 and 10", p.collision_checks);
  require(p.near_distance >= 0.0, "near_distance", "at least 0", p.near_distance);
  require(p.far_distance >= p.near_distance, "far_distance", "at least near_distance",
          p.far_distance);
  require(p.bold_distance >= 0.0, "bold_distance", "at least 0", p.bold_distance);
  require(p.pedestrian_noise >= 0.0, "pedestrian_noise", "at least 0", p.pedestrian_noise);
  require(p.reward.goal > 0.0, "reward/goal", "positive", p.reward.goal);
  require(p.reward.pedestrian <= 0.0, "reward/pedestrian", "at most 0", p.reward.pedestrian);
  require(p.reward.obstacle <= 0.0, "reward/obstacle", "at most 0", p.reward.obstacle);
  require(p.reward.sudden_brake <= 0.0, "reward/sudden_brake", "at most 0", p.reward.sudden_brake);
  require(p.reward.time <= 0.0, "reward/time", "at most 0", p.reward.time);
  require(p.reward.low_speed <= 0.0, "reward/low_speed", "at most 0", p.reward.low_speed);
}

}  // namespace pomdp_crowd_nav
