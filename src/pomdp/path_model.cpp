// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/pomdp/path_model.h"

#include <algorithm>
#include <cmath>

namespace pomdp_crowd_nav {
namespace {

constexpr float kPlacesPerMeter = 8.0F;
constexpr float kRounding = 1e-4F;  // [m], less than UpperBound allows for
constexpr float kFar = std::numeric_limits<float>::max();

float square(double x) { return static_cast<float>(x * x); }

}  // namespace

PathModel::PathModel(const ModelParams& params, const CrowdFutures& futures)
    : params_(params),
      futures_(futures),
      upper_bound_(params, Point(0.0, 0.0)),
      step_(static_cast<float>(params.step)),
      discount_(static_cast<float>(params.discount())),
      max_speed_(static_cast<float>(params.vehicle.max_speed)),
      speed_step_(static_cast<float>(params.speedStep())),
      brake_step_(params.vehicle.instant_velocity
                      ? max_speed_
                      : static_cast<float>(params.vehicle.brake_deceleration * params.step)),
      pedestrian_clearance_sq_(square(params.pedestrianClearance())) {
  validate(params);
}

void PathModel::setPath(const Path& path) {
  length_ = static_cast<float>(path.length());
  places_.clear();
  const int count = static_cast<int>(std::ceil(length_ * kPlacesPerMeter)) + 1;
  for (int i = 0; i <= count; ++i) {
    const Point place = path.positionAt(static_cast<double>(i) / kPlacesPerMeter);
    places_.push_back({static_cast<float>(place.x()), static_cast<float>(place.y())});
  }
}

PathModel::Place PathModel::placeAt(float way) const {
  const float at = std::min(way, length_) * kPlacesPerMeter;
  const auto i = static_cast<size_t>(at);
  const float share = at - static_cast<float>(i);
  const Place& a = places_[i];
  const Place& b = places_[i + 1];
  return {a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)};
}

Point PathModel::positionAt(float way) const {
  const Place place = placeAt(way);
  return {place.x, place.y};
}

bool PathModel::hasArrived(float way) const { return way >= length_ - kRounding; }

float PathModel::stepCost(float speed) const {
  const float slowness = (max_speed_ - speed) / max_speed_;
  return step_ * static_cast<float>(params_.reward.time + params_.reward.low_speed * slowness);
}

float PathModel::speedAfter(const PathState& state, const Action& action) const {
  if (action.sudden_brake) return std::max(0.0F, state.speed - brake_step_);
  const float changed = state.speed + static_cast<float>(action.speed_steps) * speed_step_;
  return std::min(std::max(changed, 0.0F), max_speed_);
}

void PathModel::actions(const PathState& state, std::vector<Action>& out) const {
  out.clear();
  if (state.speed < max_speed_) out.push_back(Action::followPrior(1));
  out.push_back(Action::followPrior(0));
  if (state.speed > 0.0F) out.push_back(Action::followPrior(-1));
  if (state.speed > speed_step_ && brake_step_ > speed_step_) out.push_back(Action::suddenBrake());
}

// After a share of a step, cut off at the end of the path.
float PathModel::wayAfter(const PathState& state, float new_speed, float share) const {
  const float mean = params_.vehicle.instant_velocity
                         ? new_speed
                         : state.speed + 0.5F * share * (new_speed - state.speed);
  return std::min(state.way + share * step_ * mean, length_);
}

PathState PathModel::move(const PathState& state, float new_speed) const {
  return {wayAfter(state, new_speed, 1.0F), new_speed};
}

float PathModel::nearestSq(const Place& robot, int scenario, int depth) const {
  const CrowdFutures::Place* people = futures_.at(scenario, depth);
  float nearest = kFar;
  for (int i = 0; i < futures_.personCount(); ++i) {
    const float dx = people[i].x - robot.x;
    const float dy = people[i].y - robot.y;
    nearest = std::min(nearest, dx * dx + dy * dy);
  }
  return nearest;
}

PathModel::Encounter PathModel::meet(const PathState& state, float new_speed, int scenario,
                                     int depth, float start_sq) const {
  const float driven = wayAfter(state, new_speed, 1.0F) - state.way;
  const int tests = std::max(1, static_cast<int>(std::ceil(driven - kRounding)));
  const CrowdFutures::Place* from = futures_.at(scenario, depth);
  const CrowdFutures::Place* to = futures_.at(scenario, depth + 1);
  float nearest = kFar;
  float end_sq = kFar;
  for (int k = 1; k <= tests; ++k) {
    const float share = static_cast<float>(k) / static_cast<float>(tests);
    const Place robot = placeAt(wayAfter(state, new_speed, share));
    end_sq = kFar;
    for (int i = 0; i < futures_.personCount(); ++i) {
      const float dx = from[i].x + share * (to[i].x - from[i].x) - robot.x;
      const float dy = from[i].y + share * (to[i].y - from[i].y) - robot.y;
      end_sq = std::min(end_sq, dx * dx + dy * dy);
    }
    nearest = std::min(nearest, end_sq);
  }
  const bool starts_close = state.speed > 0.0F && start_sq <= pedestrian_clearance_sq_;
  const bool comes_close = driven > 0.0F && nearest <= pedestrian_clearance_sq_;
  return {starts_close || comes_close, end_sq};
}

Branch PathModel::step(const PathState& state, int scenario, int depth, const Action& action,
                       PathState& next) const {
  const float speed = speedAfter(state, action);
  next = move(state, speed);
  Branch branch;
  branch.reward = stepCost(state.speed);
  if (action.sudden_brake) branch.reward += static_cast<float>(params_.reward.sudden_brake);
  branch.observation = futures_.observation(scenario, depth + 1);
  if (hasArrived(state.way)) {
    branch.reward += static_cast<float>(params_.reward.goal);
    branch.terminal = true;
    return branch;
  }
  const float start_sq = nearestSq(placeAt(state.way), scenario, depth);
  branch.terminal = meet(state, speed, scenario, depth, start_sq).collides;
  if (branch.terminal) branch.reward += static_cast<float>(params_.reward.pedestrian);
  return branch;
}

void PathModel::bound(const PathState& state, int scenario, int depth, Branch& branch) const {
  const int policies = params_.bold_rollouts ? 2 : 1;
  for (int p = 0; p < policies; ++p) branch.lower[p] = rollOut(state, scenario, depth, p);
  branch.upper = upperFrom(state);
}

// By the way along the path alone: the place told is that of the goal. UpperBound counts the way to
// within the goal's tolerance, and the path ends there.
float PathModel::upperFrom(const PathState& state) const {
  const float way = length_ - state.way + static_cast<float>(params_.goal_tolerance);
  return upper_bound_.value({0.0F, 0.0F, 1.0F, 0.0F, state.speed}, way);
}

// The default policy (paper, section Solving POMDPs Online): slow down within D_near of the nearest
// person, speed up beyond D_far, else keep.
float PathModel::rollOut(const PathState& from, int scenario, int depth, int policy) const {
  const float near_sq = square(policy == 0 ? params_.near_distance : params_.bold_distance);
  const float far_sq = square(policy == 0 ? params_.far_distance : params_.bold_distance);
  PathState state = from;
  float nearest_sq = nearestSq(placeAt(state.way), scenario, depth);
  float value = 0.0F;
  float discount = 1.0F;
  for (; depth < futures_.depth(); ++depth) {
    value += discount * stepCost(state.speed);
    if (hasArrived(state.way)) {
      return value + discount * static_cast<float>(params_.reward.goal);
    }
    float speed = state.speed;
    if (nearest_sq < near_sq) {
      speed = std::max(0.0F, speed - speed_step_);
    } else if (nearest_sq > far_sq) {
      speed = std::min(max_speed_, speed + speed_step_);
    }
    const Encounter encounter = meet(state, speed, scenario, depth, nearest_sq);
    if (encounter.collides) {
      return value + discount * static_cast<float>(params_.reward.pedestrian);
    }
    nearest_sq = encounter.end_sq;
    state = move(state, speed);
    discount *= discount_;
  }
  if (params_.beyond_horizon == BeyondHorizon::kNothing) return value;
  return value + discount * upperFrom(state);
}

Action PathModel::defaultAction(const PathState* state) const {
  float nearest_sq = kFar;
  if (futures_.scenarioCount() > 0) nearest_sq = nearestSq(placeAt(state->way), 0, 0);
  const bool is_near = nearest_sq < square(params_.near_distance);
  if (is_near) return Action::followPrior(state->speed > 0.0F ? -1 : 0);
  return Action::followPrior(state->speed < max_speed_ ? 1 : 0);
}

}  // namespace pomdp_crowd_nav
