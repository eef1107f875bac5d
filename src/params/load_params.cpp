// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/params/load_params.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "pomdp_crowd_nav/params/closest_name.h"
#include "pomdp_crowd_nav/params/param_ranges.h"
#include "pomdp_crowd_nav/params/param_values.h"
#include "pomdp_crowd_nav/planner/planner_factory.h"

namespace pomdp_crowd_nav {
namespace {

// Reads a word that names one of two values.
template <class Choice>
void readChoice(ParamReader& reader, const std::string& key, Choice& field, const char* first_name,
                Choice first, const char* second_name, Choice second) {
  std::string word = field == first ? first_name : second_name;
  reader.read(key, word);
  if (word != first_name && word != second_name) {
    throw std::invalid_argument(fmt::format("{} must be '{}' or '{}', got '{}'{}", key, first_name,
                                            second_name, word,
                                            didYouMean(word, {first_name, second_name})));
  }
  field = word == first_name ? first : second;
}

void requirePositive(const char* key, double value) {
  if (value > 0.0) return;
  throw std::invalid_argument(fmt::format("{} must be positive, got {}", key, value));
}

// A node cannot start and end its decisions faster, and a model with slower ones makes no sense.
void requireFrequency(double frequency) {
  constexpr double kLowest = 0.1, kHighest = 5.0;  // [Hz]
  if (frequency >= kLowest && frequency <= kHighest) return;
  throw std::invalid_argument(fmt::format(
      "planner_frequency must be between {:g} and {:g} Hz, got {}", kLowest, kHighest, frequency));
}

void requireHeadingWithin(const NavigationParams& params) {
  const bool turns_on_spot = params.planning.model.vehicle.kind != VehicleKind::kCar;
  if (turns_on_spot || params.yaw_goal_tolerance > M_PI) return;
  throw std::invalid_argument(
      fmt::format("yaw_goal_tolerance must be above pi for vehicle 'car', which cannot turn on the "
                  "spot, got {}",
                  params.yaw_goal_tolerance));
}

void requireKnownPlanner(const std::string& name) {
  const std::vector<std::string> names = plannerNames();
  if (std::find(names.begin(), names.end(), name) != names.end()) return;
  throw std::invalid_argument(fmt::format("planner must be one of {}, got '{}'{}",
                                          commaSeparated(names), name, didYouMean(name, names)));
}

void readVehicle(ParamReader& reader, VehicleParams& vehicle) {
  reader.read("robot_radius", vehicle.radius);
  reader.read("max_vel_trans", vehicle.max_speed);
  reader.read("acc_lim_x", vehicle.acceleration);
  reader.read("acc_lim_y", vehicle.lateral_acceleration);
  reader.read("acc_lim_theta", vehicle.yaw_acceleration);
  reader.read("max_vel_theta", vehicle.max_yaw_rate);
  reader.read("brake_deceleration", vehicle.brake_deceleration);
  reader.read("instant_velocity", vehicle.instant_velocity);
  readChoice(reader, "vehicle", vehicle.kind, "holonomic", VehicleKind::kHolonomic, "car",
             VehicleKind::kCar);
  reader.read("wheelbase", vehicle.wheelbase);
  reader.read("max_steering_angle", vehicle.max_steering_angle);
  reader.read("max_turn_per_step", vehicle.max_turn_per_step);
}

void readReward(ParamReader& reader, RewardParams& reward) {
  reader.read("reward/goal", reward.goal);
  reader.read("reward/pedestrian", reward.pedestrian);
  reader.read("reward/obstacle", reward.obstacle);
  reader.read("reward/sudden_brake", reward.sudden_brake);
  reader.read("reward/time", reward.time);
  reader.read("reward/low_speed", reward.low_speed);
}

void readModel(ParamReader& reader, ModelParams& model) {
  readVehicle(reader, model.vehicle);
  readReward(reader, model.reward);
  double frequency = 1.0 / model.step;
  if (reader.read("planner_frequency", frequency)) {
    requireFrequency(frequency);
    model.step = 1.0 / frequency;
  }
  reader.read("xy_goal_tolerance", model.goal_tolerance);
  reader.read("model/horizon", model.horizon);
  reader.read("model/discount", model.discount_per_second);
  reader.read("model/pedestrian_distance", model.pedestrian_distance);
  reader.read("model/obstacle_distance", model.obstacle_distance);
  reader.read("model/collision_checks", model.collision_checks);
  reader.read("model/near_distance", model.near_distance);
  reader.read("model/far_distance", model.far_distance);
  reader.read("model/bold_rollouts", model.bold_rollouts);
  reader.read("model/bold_distance", model.bold_distance);
  reader.read("model/pedestrian_noise", model.pedestrian_noise);
  readChoice(reader, "model/beyond_horizon", model.beyond_horizon, "nothing",
             BeyondHorizon::kNothing, "free_drive", BeyondHorizon::kFreeDrive);
  readChoice(reader, "model/upper_bound", model.upper_bound, "paper", UpperBoundKind::kPaper,
             "tight", UpperBoundKind::kTight);
}

void readLimitedSpace(ParamReader& reader, LimitedSpaceParams& limited_space) {
  reader.read("path/pace", limited_space.pace);
  reader.read("path/time_share", limited_space.time_share);
  reader.read("path/max_expansions", limited_space.max_expansions);
  reader.read("path/pedestrian_noise", limited_space.pedestrian_noise);
  HybridAstar::Params& path = limited_space.path;
  reader.read("path/cell", path.cell);
  reader.read("path/cost_discount", path.cost_discount);
  reader.read("path/way_weight", path.way_weight);
  reader.read("path/heading_weight", path.heading_weight);
  reader.read("path/field_strength", path.crowd.field_strength);
  reader.read("path/field_radius", path.crowd.field_radius);
  reader.read("path/field_on_way", path.crowd.field_on_way);
  reader.read("path/sure_belief", path.crowd.sure_belief);
}

void readPlanning(ParamReader& reader, PlannerParams& planning) {
  readModel(reader, planning.model);
  reader.read("attended_pedestrians", planning.pedestrians);
  reader.read("attention_angle", planning.attention_angle);
  reader.read("attention_lookahead", planning.attention_lookahead);
  reader.read("search/scenarios", planning.search.scenarios);
  reader.read("search/regularization", planning.search.regularization);
  reader.read("search/target_gap", planning.search.target_gap);
  reader.read("search/max_nodes", planning.search.max_nodes);
  reader.read("search/max_memory", planning.search.max_memory);
  reader.read("search/threads", planning.search.threads);
  reader.read("prior/resolution", planning.prior.resolution);
  reader.read("prior/extra_clearance", planning.prior.extra_clearance);
  reader.read("prior/blocked_speed", planning.prior.blocked_speed);
  reader.read("prior/narrow_speed", planning.prior.narrow_speed);
  reader.read("prior/saturation_distance", planning.prior.saturation_distance);
  reader.read("prior/look_ahead", planning.prior.look_ahead);
  reader.read("prior/milestones", planning.prior.milestones);
  reader.read("prior/neighbours", planning.prior.neighbours);
  reader.read("prior/milestone_spacing", planning.prior.milestone_spacing);
  reader.read("prior/seed", planning.prior.seed);
  readLimitedSpace(reader, planning.limited_space);
}

void readSafety(ParamReader& reader, NavigationParams& params) {
  reader.read("belief/update_period", params.belief.update_period);
  reader.read("belief/walking_speed", params.belief.walking_speed);
  reader.read("belief/memory", params.belief.memory);
  reader.read("belief/speed_smoothing", params.belief.speed_smoothing);
  reader.read("belief/inherit_distance", params.belief.inherit_distance);
  reader.read("belief/elsewhere", params.belief.expect_elsewhere);
  reader.read("belief/position_noise", params.belief.intention.position_noise);
  reader.read("belief/change_rate", params.belief.intention.change_rate);
  reader.read("emergency/enabled", params.emergency.enabled);
  reader.read("emergency/decision_distance", params.emergency.decision_distance);
  reader.read("emergency/reflex_distance", params.emergency.reflex_distance);
  reader.read("emergency/reaction_time", params.emergency.reaction_time);
  reader.read("command/hold_time", params.command.hold_time);
  reader.read("command/yaw_gain", params.command.yaw_gain);
  reader.read("trans_stopped_vel", params.trans_stopped_vel);
  reader.read("rot_stopped_vel", params.rot_stopped_vel);
  reader.read("progress_distance", params.progress.distance);
  reader.read("blocked_timeout", params.progress.blocked_timeout);
  reader.read("abort_timeout", params.progress.abort_timeout);
  reader.read("odom_timeout", params.odom_timeout);
  reader.read("people_timeout", params.people_timeout);
  reader.read("transform_tolerance", params.transform_tolerance);
}

void readGuard(ParamReader& reader, NavigationParams& params) {
  reader.read("guard/frequency", params.guard.frequency);
  reader.read("guard/command_timeout", params.guard.command_timeout);
  reader.read("guard/margin", params.guard.margin);
  reader.read("guard/reaction_time", params.guard.reaction_time);
  reader.read("guard/hold_time", params.guard.hold_time);
  params.guard.odom_timeout = params.odom_timeout;
  params.guard.people_timeout = params.people_timeout;
}

void requireNarrowSpeed(const PriorParams& prior) {
  if (prior.narrow_speed >= prior.blocked_speed && prior.narrow_speed <= 1.0) return;
  throw std::invalid_argument(
      fmt::format("prior/narrow_speed must be between prior/blocked_speed ({}) and 1, got {}",
                  prior.blocked_speed, prior.narrow_speed));
}

}  // namespace

void readNavigationParams(ParamReader& reader, NavigationParams& params) {
  reader.read("planner", params.planner);
  readPlanning(reader, params.planning);
  readSafety(reader, params);
  reader.read("search_time", params.search_time);
  reader.read("controller_frequency", params.controller_frequency);
  reader.read("yaw_goal_tolerance", params.yaw_goal_tolerance);
  readGuard(reader, params);
  reader.read("display/tree_depth", params.tree_depth);
}

void validate(const NavigationParams& params) {
  requireKnownPlanner(params.planner);
  requireNarrowSpeed(params.planning.prior);
  requireDrives(params.planner, params.planning.model.vehicle);
  validate(params.planning);
  requirePositive("search_time", params.search_time);
  requirePositive("controller_frequency", params.controller_frequency);
  requirePositive("yaw_goal_tolerance", params.yaw_goal_tolerance);
  requireHeadingWithin(params);
  requirePositive("trans_stopped_vel", params.trans_stopped_vel);
  requirePositive("rot_stopped_vel", params.rot_stopped_vel);
  ProgressWatch{params.progress};  // throws where they make no sense
  requirePositive("odom_timeout", params.odom_timeout);
  requirePositive("people_timeout", params.people_timeout);
  validate(params.guard);
  requireWithinRanges(valuesOf(params));
}

NavigationParams loadNavigationParams(ParamReader& reader) {
  NavigationParams params;
  params.planning.model.step = 0.5;
  readNavigationParams(reader, params);
  validate(params);
  return params;
}

Simulator::Params loadSimulatorParams(ParamReader& reader, const VehicleParams& vehicle) {
  Simulator::Params params;
  params.vehicle = vehicle;
  reader.read("sensor/range", params.sensor.range);
  reader.read("sensor/position_noise", params.sensor.position_noise);
  reader.read("sensor/dropout", params.sensor.dropout);
  reader.read("sensor/velocity_window", params.sensor.velocity_window);
  reader.read("command_timeout", params.command_timeout);
  reader.read("crowd", params.crowd);
  reader.read("uniform_respawn", params.uniform_respawn);
  return params;
}

}  // namespace pomdp_crowd_nav
