// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/pomdp/upper_bound.h"

#include <algorithm>
#include <cmath>

namespace pomdp_crowd_nav {
namespace {

constexpr int kTabulated = 4000;    // steps; farther away the bound no longer changes
constexpr float kRounding = 1e-3F;  // [steps] given away, so that float errors stay optimistic

// Steps of `length` needed to cover `distance`, at most the last one tabulated.
int stepsFor(float distance, float length) {
  if (distance <= 0.0F) return 0;
  const float steps = std::ceil(distance / length - kRounding);
  return std::clamp(static_cast<int>(std::min(steps, 1e6F)), 0, kTabulated - 1);
}

}  // namespace

UpperBound::UpperBound(const ModelParams& params, const Point& goal,
                       const ShortestWay* shortest_way)
    : kind_(params.upper_bound),
      goal_(goal),
      shortest_way_(shortest_way),
      goal_tolerance_(static_cast<float>(params.goal_tolerance)),
      max_speed_(static_cast<float>(params.vehicle.max_speed)),
      speed_step_(static_cast<float>(params.speedStep())),
      step_(static_cast<float>(params.step)),
      goal_reward_(static_cast<float>(params.reward.goal)),
      time_cost_(static_cast<float>(params.reward.time * params.step)),
      low_speed_cost_(static_cast<float>(params.reward.low_speed * params.step)),
      discount_(static_cast<float>(params.discount())),
      instant_(params.vehicle.instant_velocity) {
  double discount = 1.0;
  double costs = 0.0;
  for (int n = 0; n < kTabulated; ++n) {
    discounts_.push_back(static_cast<float>(discount));
    costs += discount * time_cost_;
    full_speed_.push_back(static_cast<float>(discount * goal_reward_ + costs));
    discount *= discount_;
  }
}

float UpperBound::value(const RobotState& state, float way_to_goal) const {
  const float dx = static_cast<float>(goal_.x()) - state.x;
  const float dy = static_cast<float>(goal_.y()) - state.y;
  float distance = std::max(std::sqrt(dx * dx + dy * dy), way_to_goal) - goal_tolerance_;
  if (kind_ == UpperBoundKind::kPaper) {
    return discounts_[stepsFor(distance, max_speed_ * step_)] * goal_reward_;
  }
  if (shortest_way_ != nullptr) {
    distance = std::max(distance, shortest_way_->lengthFrom(state.x, state.y));
  }
  return tightValue(state.speed, distance);
}

float UpperBound::tightValue(float speed, float distance) const {
  float value = 0.0F;
  float discount = 1.0F;
  while (distance > kRounding && speed < max_speed_ - 1e-4F) {
    value += discount * (time_cost_ + low_speed_cost_ * (1.0F - speed / max_speed_));
    const float next = std::min(speed + speed_step_, max_speed_);
    distance -= step_ * (instant_ ? next : 0.5F * (speed + next));
    speed = next;
    discount *= discount_;
  }
  value += discount * full_speed_[stepsFor(distance, max_speed_ * step_)];
  return std::max(value, 0.0F);
}

std::optional<ShortestWay> makeShortestWay(const ModelParams& params, const ClearanceGrid& map,
                                           const Point& goal) {
  if (params.upper_bound != UpperBoundKind::kTight || !map.map.hasObstacles()) return std::nullopt;
  // A step is tested at even parts of it, by the cells there, and each part covers at most that
  // share of the longest step (moveRobots). Who is clear of obstacles stays so or earns nothing.
  const double stride = params.vehicle.max_speed * params.step * 2.0 / params.collision_checks;
  return ShortestWay(map, goal, {params.obstacleClearance(), stride, params.goal_tolerance});
}

}  // namespace pomdp_crowd_nav
