// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/pomdp/step_constants.h"

#include <algorithm>

namespace pomdp_crowd_nav {
namespace {

float square(double x) { return static_cast<float>(x * x); }

}  // namespace

StepConstants::StepConstants(const ModelParams& p, const NavigationField& field) {
  const VehicleParams& v = p.vehicle;
  const auto step = static_cast<float>(p.step);
  instant = v.instant_velocity;
  max_speed = static_cast<float>(v.max_speed);
  speed_step = static_cast<float>(p.speedStep());
  brake_step = instant ? 1e9F : static_cast<float>(v.brake_deceleration * p.step);
  turn_speed = instant ? 1e9F : static_cast<float>(v.lateral_acceleration * p.step);
  end_old = instant ? 0.0F : 0.5F * step;
  end_new = instant ? step : 0.5F * step;
  vias = p.collision_checks - 1;
  for (int k = 0; k < kMaxVias; ++k) {
    // Of a velocity that runs linearly from old to new: (3 old + new) / 8 of a step by its middle.
    const double s = std::min(1.0, (k + 1.0) / p.collision_checks);
    const auto ramp = static_cast<float>(0.5 * s * s);
    share[k] = static_cast<float>(s);
    via_old[k] = instant ? 0.0F : (share[k] - ramp) * step;
    via_new[k] = instant ? share[k] * step : ramp * step;
  }
  goal_x = static_cast<float>(field.goal().x());
  goal_y = static_cast<float>(field.goal().y());
  goal_tolerance_sq = square(p.goal_tolerance);
  min_x = static_cast<float>(field.bounds().min.x());
  min_y = static_cast<float>(field.bounds().min.y());
  max_x = static_cast<float>(field.bounds().max.x());
  max_y = static_cast<float>(field.bounds().max.y());
  pedestrian_clearance_sq = square(p.pedestrianClearance());
  obstacle_clearance = static_cast<float>(p.obstacleClearance());
  rules[0] = {square(p.near_distance), square(p.far_distance)};
  rules[1] = {square(p.bold_distance), square(p.bold_distance)};
  policy_count = p.bold_rollouts ? 2 : 1;
  reach = static_cast<float>(0.01 +
                             std::max({p.far_distance, p.bold_distance, p.pedestrianClearance()}));
  longest_stride = static_cast<float>(v.max_speed * p.step);
  goal_reward = static_cast<float>(p.reward.goal);
  pedestrian_penalty = static_cast<float>(p.reward.pedestrian);
  obstacle_penalty = static_cast<float>(p.reward.obstacle);
  brake_penalty = static_cast<float>(p.reward.sudden_brake);
  time_cost = static_cast<float>(p.reward.time * p.step);
  low_speed_cost = static_cast<float>(p.reward.low_speed * p.step);
  discount = static_cast<float>(p.discount());
  has_obstacles = field.hasObstacles();
  is_car = v.kind == VehicleKind::kCar;
  heads_for_goal = is_car && field.isStraightLine();
  max_curvature = static_cast<float>(maxCurvature(v));
  max_turn = static_cast<float>(v.max_turn_per_step);
  max_yaw_rate = static_cast<float>(v.max_yaw_rate);
  max_lateral = instant ? 1e9F : static_cast<float>(v.lateral_acceleration);
}

}  // namespace pomdp_crowd_nav
