// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/params/load_params.h"

#include <gtest/gtest.h>

#include <functional>
#include <stdexcept>

#include "pomdp_crowd_nav/params/yaml_param_reader.h"

namespace pomdp_crowd_nav {
namespace {

struct Profile {
  NavigationParams navigation;
  Simulator::Params simulator;
};

Profile load(YamlParamReader reader) {
  Profile profile;
  profile.navigation = loadNavigationParams(reader);
  profile.simulator = loadSimulatorParams(reader, profile.navigation.planning.model.vehicle);
  reader.requireAllUsed();
  return profile;
}

Profile loadShipped(const std::string& name) {
  return load(YamlParamReader::fromFile(SOURCE_DIR "/config/profiles/" + name + ".yaml"));
}

std::string messageFor(const std::string& text) {
  try {
    load(YamlParamReader::fromText(text, "test.yaml"));
  } catch (const std::exception& error) {
    return error.what();
  }
  return "accepted";
}

class ShippedProfile : public testing::TestWithParam<const char*> {};

TEST_P(ShippedProfile, LoadsWithoutAnUnknownKey) {
  EXPECT_NO_THROW(loadShipped(GetParam()));
  const Profile profile = loadShipped(GetParam());
  EXPECT_NO_THROW(validate(profile.navigation.planning));
  // The search ends before its decision is due.
  EXPECT_LE(profile.navigation.search_time, profile.navigation.planning.model.step);
}

INSTANTIATE_TEST_SUITE_P(EveryProfile, ShippedProfile,
                         testing::Values("paper", "paper_car", "tuned", "movo", "movo_stock",
                                         "street"),
                         [](const auto& test) { return std::string(test.param); });

TEST(LoadParams, ThePapersCarHasThePapersConstants) {
  const NavigationParams params = loadShipped("paper_car").navigation;
  const NavigationParams holonomic = loadShipped("paper").navigation;
  const ModelParams& model = params.planning.model;
  EXPECT_EQ(params.planner, "2d_nhv");
  EXPECT_EQ(model.vehicle.kind, VehicleKind::kCar);
  EXPECT_EQ(model.vehicle.max_speed, 4.0);
  EXPECT_EQ(model.vehicle.wheelbase, 1.0);
  EXPECT_NEAR(model.vehicle.max_turn_per_step, M_PI / 4.0, 1e-6);
  EXPECT_GT(maxCurvature(model.vehicle), M_PI / 4.0) << "45 degrees at 1 m/s";
  EXPECT_EQ(model.collision_checks, 5);
  EXPECT_NEAR(params.planning.attention_angle, 2.0 * M_PI / 3.0, 1e-6);
  EXPECT_EQ(model.near_distance, holonomic.planning.model.near_distance);
  EXPECT_EQ(model.far_distance, holonomic.planning.model.far_distance);
  EXPECT_EQ(model.reward.sudden_brake, holonomic.planning.model.reward.sudden_brake);
  EXPECT_EQ(params.planning.search.scenarios, holonomic.planning.search.scenarios);
}

TEST(LoadParams, AVehicleNeedsAPlannerForIt) {
  EXPECT_NE(messageFor("vehicle: boat").find("vehicle must be 'holonomic' or 'car', got 'boat'"),
            std::string::npos)
      << messageFor("vehicle: boat");
  EXPECT_NE(messageFor("vehicle: car").find("for vehicle 'car', got '2d_fmm'"), std::string::npos)
      << messageFor("vehicle: car");
  EXPECT_EQ(messageFor("{vehicle: car, planner: 2d_nhv}"), "accepted");
  EXPECT_NE(messageFor("planner: 2d_nhv").find("for vehicle 'holonomic'"), std::string::npos);
  EXPECT_NE(messageFor("{vehicle: car, planner: 2d_nhv, yaw_goal_tolerance: 0.5}")
                .find("yaw_goal_tolerance must be above pi for vehicle 'car'"),
            std::string::npos);
}

TEST(LoadParams, ThePapersProfileHoldsThePapersConstants) {
  const NavigationParams params = loadShipped("paper").navigation;
  const ModelParams& model = params.planning.model;
  EXPECT_EQ(params.planner, "2d_fmm");
  EXPECT_EQ(model.step, 1.0);
  EXPECT_EQ(model.depth(), 100);
  EXPECT_TRUE(model.vehicle.instant_velocity);
  EXPECT_EQ(model.vehicle.max_speed, 2.0);
  EXPECT_EQ(model.speedStep(), 1.0);
  EXPECT_EQ(model.pedestrianClearance(), 2.0);
  EXPECT_EQ(model.obstacleClearance(), 3.0);
  EXPECT_EQ(model.near_distance, 4.0);
  EXPECT_EQ(model.far_distance, 6.0);
  EXPECT_EQ(model.reward.goal, 1000.0);
  EXPECT_EQ(model.reward.pedestrian, -100.0);
  EXPECT_EQ(model.reward.sudden_brake, -10.0);
  EXPECT_EQ(params.planning.search.scenarios, 100);
  EXPECT_EQ(params.planning.pedestrians, 6);
  EXPECT_EQ(params.emergency.decision_distance, 2.0);
}

TEST(LoadParams, TheMovoIsARampedBase) {
  const Profile profile = loadShipped("movo");
  const ModelParams& model = profile.navigation.planning.model;
  EXPECT_FALSE(model.vehicle.instant_velocity);
  EXPECT_EQ(model.step, 0.5);
  EXPECT_EQ(model.speedStep(), 0.5);
  EXPECT_EQ(model.vehicle.max_speed, 1.0);
  EXPECT_EQ(model.beyond_horizon, BeyondHorizon::kFreeDrive);
  EXPECT_FALSE(profile.simulator.vehicle.instant_velocity) << "the simulator drives the same base";
  EXPECT_EQ(profile.simulator.sensor.range, 30.0);
}

// It is what a MOVO's base does before anybody raises its limits: 0.5 m/s, 1 m/s^2, 1 rad/s.
TEST(LoadParams, TheStockMovoKeepsTheLimitsThatItsBaseComesWith) {
  const ModelParams model = loadShipped("movo_stock").navigation.planning.model;
  const ModelParams fast = loadShipped("movo").navigation.planning.model;
  EXPECT_LE(model.vehicle.max_speed, 0.5);
  EXPECT_LE(model.vehicle.acceleration, 1.0);
  EXPECT_LE(model.vehicle.max_yaw_rate, 1.0);
  EXPECT_EQ(model.speedStep(), 0.5);
  EXPECT_EQ(model.vehicle.radius, fast.vehicle.radius);
  EXPECT_GE(model.horizon * model.vehicle.max_speed, fast.horizon * fast.vehicle.max_speed)
      << "as long a way";
}

TEST(LoadParams, AnEmptyProfileIsTheDefaults) {
  const NavigationParams loaded = load(YamlParamReader::fromText("{}", "test.yaml")).navigation;
  const NavigationParams defaults;
  EXPECT_EQ(loaded.planner, defaults.planner);
  EXPECT_EQ(loaded.search_time, defaults.search_time);
  EXPECT_EQ(loaded.planning.model.step, 0.5) << "2 Hz";
  EXPECT_EQ(loaded.planning.model.upper_bound, defaults.planning.model.upper_bound);
  EXPECT_EQ(loaded.planning.search.scenarios, defaults.planning.search.scenarios);
  EXPECT_EQ(loaded.emergency.reflex_distance, defaults.emergency.reflex_distance);
  EXPECT_EQ(loaded.command.hold_time, defaults.command.hold_time);
}

// Every key is read into the field it names.
TEST(LoadParams, ReadsEveryKey) {
  const Profile p = load(YamlParamReader::fromText(R"(
planner: 2d_straight
planner_frequency: 4.0
controller_frequency: 41.0
search_time: 0.15
instant_velocity: false
robot_radius: 0.31
max_vel_trans: 1.01
acc_lim_x: 1.02
acc_lim_y: 1.03
acc_lim_theta: 1.04
max_vel_theta: 1.05
brake_deceleration: 1.06
xy_goal_tolerance: 0.41
yaw_goal_tolerance: 0.42
odom_timeout: 0.43
people_timeout: 0.44
transform_tolerance: 0.45
attended_pedestrians: 5
attention_angle: 2.1
attention_lookahead: 1.2
model: {horizon: 31.0, discount: 0.93, pedestrian_distance: 0.51, obstacle_distance: 0.52,
        near_distance: 2.51, far_distance: 3.51, bold_rollouts: false, bold_distance: 1.51,
        pedestrian_noise: 0.11, beyond_horizon: free_drive, upper_bound: paper}
reward: {goal: 901.0, pedestrian: -91.0, obstacle: -92.0, sudden_brake: -9.0, time: -1.1,
         low_speed: -1.2}
search: {scenarios: 61, regularization: 0.02, target_gap: 0.9, max_nodes: 12345,
         max_memory: 77.0, threads: 3}
prior: {resolution: 0.3, extra_clearance: 0.31, blocked_speed: 0.02, narrow_speed: 0.2, milestones: 501, neighbours: 7,
        milestone_spacing: 1.1, seed: 13}
path: {pace: 1.4, time_share: 0.4, max_expansions: 4321, pedestrian_noise: 0.07, cell: 0.6,
       cost_discount: 0.98, way_weight: 0.9, heading_weight: 9.0, field_strength: 8.0,
       field_radius: 15.0, field_on_way: true, sure_belief: 0.6}
belief: {update_period: 0.6, walking_speed: 1.3, speed_smoothing: 0.4}
emergency: {enabled: false, decision_distance: 1.7, reflex_distance: 1.1, reaction_time: 0.25}
command: {hold_time: 0.12, yaw_gain: 1.8}
sensor: {range: 21.0, position_noise: 0.05, dropout: 0.1, velocity_window: 0.7}
command_timeout: 0.6
uniform_respawn: true
)",
                                                   "test.yaml"));
  const NavigationParams& n = p.navigation;
  const ModelParams& m = n.planning.model;
  EXPECT_EQ(n.planner, "2d_straight");
  EXPECT_EQ(m.step, 0.25);
  EXPECT_EQ(n.controller_frequency, 41.0);
  EXPECT_EQ(n.search_time, 0.15);
  EXPECT_FALSE(m.vehicle.instant_velocity);
  EXPECT_EQ(m.vehicle.radius, 0.31);
  EXPECT_EQ(m.vehicle.max_speed, 1.01);
  EXPECT_EQ(m.vehicle.acceleration, 1.02);
  EXPECT_EQ(m.vehicle.lateral_acceleration, 1.03);
  EXPECT_EQ(m.vehicle.yaw_acceleration, 1.04);
  EXPECT_EQ(m.vehicle.max_yaw_rate, 1.05);
  EXPECT_EQ(m.vehicle.brake_deceleration, 1.06);
  EXPECT_EQ(m.goal_tolerance, 0.41);
  EXPECT_EQ(n.yaw_goal_tolerance, 0.42);
  EXPECT_EQ(n.odom_timeout, 0.43);
  EXPECT_EQ(n.people_timeout, 0.44);
  EXPECT_EQ(n.transform_tolerance, 0.45);
  EXPECT_EQ(n.planning.pedestrians, 5);
  EXPECT_EQ(n.planning.attention_angle, 2.1);
  EXPECT_EQ(n.planning.attention_lookahead, 1.2);
  EXPECT_EQ(m.horizon, 31.0);
  EXPECT_EQ(m.discount_per_second, 0.93);
  EXPECT_EQ(m.pedestrian_distance, 0.51);
  EXPECT_EQ(m.obstacle_distance, 0.52);
  EXPECT_EQ(m.near_distance, 2.51);
  EXPECT_EQ(m.far_distance, 3.51);
  EXPECT_FALSE(m.bold_rollouts);
  EXPECT_EQ(m.bold_distance, 1.51);
  EXPECT_EQ(m.pedestrian_noise, 0.11);
  EXPECT_EQ(m.beyond_horizon, BeyondHorizon::kFreeDrive);
  EXPECT_EQ(m.upper_bound, UpperBoundKind::kPaper);
  EXPECT_EQ(m.reward.goal, 901.0);
  EXPECT_EQ(m.reward.pedestrian, -91.0);
  EXPECT_EQ(m.reward.obstacle, -92.0);
  EXPECT_EQ(m.reward.sudden_brake, -9.0);
  EXPECT_EQ(m.reward.time, -1.1);
  EXPECT_EQ(m.reward.low_speed, -1.2);
  EXPECT_EQ(n.planning.search.scenarios, 61);
  EXPECT_EQ(n.planning.search.regularization, 0.02);
  EXPECT_EQ(n.planning.search.target_gap, 0.9);
  EXPECT_EQ(n.planning.search.max_nodes, 12345);
  EXPECT_EQ(n.planning.search.max_memory, 77.0);
  EXPECT_EQ(n.planning.search.threads, 3);
  EXPECT_EQ(n.planning.prior.resolution, 0.3);
  EXPECT_EQ(n.planning.prior.extra_clearance, 0.31);
  EXPECT_EQ(n.planning.prior.blocked_speed, 0.02);
  EXPECT_EQ(n.planning.prior.narrow_speed, 0.2);
  EXPECT_EQ(n.planning.prior.milestones, 501);
  EXPECT_EQ(n.planning.prior.neighbours, 7);
  EXPECT_EQ(n.planning.prior.milestone_spacing, 1.1);
  EXPECT_EQ(n.planning.prior.seed, 13);
  const LimitedSpaceParams& limited_space = n.planning.limited_space;
  EXPECT_EQ(limited_space.pace, 1.4);
  EXPECT_EQ(limited_space.time_share, 0.4);
  EXPECT_EQ(limited_space.max_expansions, 4321);
  EXPECT_EQ(limited_space.pedestrian_noise, 0.07);
  EXPECT_EQ(limited_space.path.cell, 0.6);
  EXPECT_EQ(limited_space.path.cost_discount, 0.98);
  EXPECT_EQ(limited_space.path.way_weight, 0.9);
  EXPECT_EQ(limited_space.path.heading_weight, 9.0);
  EXPECT_EQ(limited_space.path.crowd.field_strength, 8.0);
  EXPECT_EQ(limited_space.path.crowd.field_radius, 15.0);
  EXPECT_TRUE(limited_space.path.crowd.field_on_way);
  EXPECT_EQ(limited_space.path.crowd.sure_belief, 0.6);
  EXPECT_EQ(n.belief.update_period, 0.6);
  EXPECT_EQ(n.belief.walking_speed, 1.3);
  EXPECT_EQ(n.belief.speed_smoothing, 0.4);
  EXPECT_FALSE(n.emergency.enabled);
  EXPECT_EQ(n.emergency.decision_distance, 1.7);
  EXPECT_EQ(n.emergency.reflex_distance, 1.1);
  EXPECT_EQ(n.emergency.reaction_time, 0.25);
  EXPECT_EQ(n.command.hold_time, 0.12);
  EXPECT_EQ(n.command.yaw_gain, 1.8);
  EXPECT_EQ(p.simulator.sensor.range, 21.0);
  EXPECT_EQ(p.simulator.sensor.position_noise, 0.05);
  EXPECT_EQ(p.simulator.sensor.dropout, 0.1);
  EXPECT_EQ(p.simulator.sensor.velocity_window, 0.7);
  EXPECT_EQ(p.simulator.command_timeout, 0.6);
  EXPECT_TRUE(p.simulator.uniform_respawn);
  EXPECT_EQ(p.simulator.vehicle.radius, 0.31);
}

TEST(LoadParams, AMisspeltKeyNamesTheOneThatWasMeant) {
  EXPECT_EQ(messageFor("max_vel_tran: 1.0"),
            "test.yaml: unknown key 'max_vel_tran', did you mean 'max_vel_trans'?");
  EXPECT_EQ(messageFor("model: {horizn: 50.0}"),
            "test.yaml: unknown key 'model/horizn', did you mean 'model/horizon'?");
  EXPECT_EQ(messageFor("search: {scenario: 50}"),
            "test.yaml: unknown key 'search/scenario', did you mean 'search/scenarios'?");
}

TEST(LoadParams, AWrongTypeNamesTheKey) {
  EXPECT_EQ(messageFor("search: {scenarios: many}"),
            "test.yaml: search/scenarios: expected an integer from -2147483648 to 2147483647, got "
            "'many'");
  EXPECT_EQ(messageFor("instant_velocity: 1"),
            "test.yaml: instant_velocity: expected true or false, got '1'");
}

TEST(LoadParams, AValueOutOfRangeIsRefused) {
  EXPECT_EQ(messageFor("model: {discount: 1.2}"), "discount must be in (0, 1), got 1.2");
  EXPECT_EQ(messageFor("planner_frequency: -0.5"),
            "planner_frequency must be between 0.1 and 5 Hz, got -0.5");
  EXPECT_EQ(messageFor("planner_frequency: 5.5"),
            "planner_frequency must be between 0.1 and 5 Hz, got 5.5");
  EXPECT_EQ(messageFor("planner: fmm"),
            "planner must be one of 2d_fmm, 2d_prm, 2d_straight, 2d_nhv, 2d_nhv_fm2, 1d_astar, "
            "got 'fmm', did you mean '2d_fmm'?");
  EXPECT_EQ(messageFor("search_time: -0.5"), "search_time must be positive, got -0.5");
  EXPECT_EQ(messageFor("controller_frequency: -0.5"),
            "controller_frequency must be positive, got -0.5");
  EXPECT_EQ(messageFor("yaw_goal_tolerance: -0.5"),
            "yaw_goal_tolerance must be positive, got -0.5");
  EXPECT_EQ(messageFor("odom_timeout: -0.5"), "odom_timeout must be positive, got -0.5");
  EXPECT_EQ(messageFor("people_timeout: -0.5"), "people_timeout must be positive, got -0.5");
  EXPECT_EQ(messageFor("robot_radius: -0.5"), "robot_radius must be positive, got -0.5");
  EXPECT_EQ(messageFor("attended_pedestrians: 65"),
            "attended_pedestrians must be between 0 and 64, got 65");
  EXPECT_EQ(messageFor("path: {time_share: 1.5}"), "path/time_share must be in (0, 1), got 1.5");
  EXPECT_EQ(messageFor("path: {max_expansions: 0}"),
            "path/max_expansions must be at least 1, got 0");
  EXPECT_EQ(messageFor("path: {pedestrian_noise: -0.5}"),
            "path/pedestrian_noise must be at least 0, got -0.5");
  EXPECT_EQ(messageFor("path: {pace: -0.5}"), "path/pace must be at least 0, got -0.5");
  EXPECT_EQ(messageFor("path: {cell: -0.5}"), "path/cell must be positive, got -0.5");
  EXPECT_EQ(messageFor("search: {scenarios: 0}"),
            "search/scenarios must be between 1 and 65535, got 0");
  EXPECT_EQ(messageFor("model: {bold_distance: -0.5}"),
            "bold_distance must be at least 0, got -0.5");
  EXPECT_EQ(messageFor("model: {upper_bound: loose}"),
            "model/upper_bound must be 'paper' or 'tight', got 'loose'");
  EXPECT_EQ(messageFor("model: {beyond_horizon: heaven}"),
            "model/beyond_horizon must be 'nothing' or 'free_drive', got 'heaven'");
}

TEST(LoadParams, NarrowWaysAreNoSlowerThanBlockedOnes) {
  EXPECT_EQ(messageFor("prior: {blocked_speed: 0.2, narrow_speed: 0.1}"),
            "prior/narrow_speed must be between prior/blocked_speed (0.2) and 1, got 0.1");
  EXPECT_EQ(messageFor("prior: {blocked_speed: 0.2, narrow_speed: 0.2}"), "accepted");
}

}  // namespace
}  // namespace pomdp_crowd_nav
