// SPDX-License-Identifier: BSD-3-Clause
// Whole trips, in the shipped worlds with the shipped profiles.
#include "pomdp_crowd_nav/evaluation/episode.h"

#include <gtest/gtest.h>

#include <cmath>

#include "pomdp_crowd_nav/params/yaml_param_reader.h"

namespace pomdp_crowd_nav {
namespace {

constexpr long kTrials = 30;  // a decision

EpisodeParams loadParams(const std::string& profile, int pedestrians) {
  auto reader = YamlParamReader::fromFile(SOURCE_DIR "/config/profiles/" + profile + ".yaml");
  EpisodeParams params;
  params.navigation = loadNavigationParams(reader);
  params.simulator = loadSimulatorParams(reader, params.navigation.planning.model.vehicle);
  params.simulator.pedestrians = pedestrians;
  params.max_trials = kTrials;
  return params;
}

World loadShipped(const std::string& name) {
  return loadWorld(SOURCE_DIR "/config/worlds/" + name + ".yaml");
}

class PaperEpisode : public testing::TestWithParam<std::pair<const char*, int>> {};

TEST_P(PaperEpisode, EndsSafelyAtTheGoal) {
  const World world = loadShipped(GetParam().first);
  const EpisodeParams params = loadParams("paper", GetParam().second);
  const StaticMap map = world.map();
  const EpisodeResult result = runEpisode(world, params);
  EXPECT_EQ(result.end, EpisodeEnd::kGoalReached) << describe(result.end);
  EXPECT_EQ(result.metrics.unsafe_steps, 0);
  EXPECT_EQ(result.metrics.unsafe_ticks, 0);
  EXPECT_EQ(result.bound_violations, 0);
  EXPECT_GT(result.metrics.min_moving_distance, 1.0);
  // 110.9 m at 2 m/s and the first second of watching; a corridor adds to it.
  EXPECT_GE(result.metrics.travel_time, 56.0);
  EXPECT_LT(result.metrics.travel_time, 130.0);
  EXPECT_LE(result.metrics.max_speed, 2.0 + 1e-9);
  EXPECT_NEAR(result.mean_trials, kTrials, kTrials) << "a closed gap ends a search earlier";
  EXPECT_EQ(result.trail.size(), static_cast<size_t>(std::lround(result.metrics.travel_time * 10)));
  EXPECT_EQ(result.metrics.decisions, std::lround(result.metrics.travel_time) - 1);
  for (const Point& place : result.trail) {
    // The goal is on the border, give or take rounding.
    const Point inside = place.cwiseMax(map.bounds().min).cwiseMin(map.bounds().max);
    ASSERT_LT((place - inside).norm(), 1e-9);
    ASSERT_GT(map.clearance(place), 2.0);
  }
  for (size_t i = 0; i < 10; ++i) EXPECT_EQ(result.trail[i], world.start.position) << "it watches";
}

INSTANTIATE_TEST_SUITE_P(EveryWorld, PaperEpisode,
                         testing::Values(std::make_pair("scenario_1", 60),
                                         std::make_pair("scenario_2", 40),
                                         std::make_pair("scenario_3", 30)),
                         [](const auto& test) { return std::string(test.param.first); });

// Turns between the ways of a tick and the next: the mean curvature times the distance of their
// middles.
void expectDrivenByACar(const std::vector<Point>& trail, double heading, const VehicleParams& car) {
  constexpr double kTolerance = 1e-6;
  double last_length = 0.0;
  for (size_t i = 1; i < trail.size(); ++i) {
    const Point way = trail[i] - trail[i - 1];
    if (way.norm() < 1e-9) continue;
    const double turn = std::abs(wrapAngle(bearing({0.0, 0.0}, way) - heading));
    ASSERT_LE(turn, 0.5 * (last_length + 1.001 * way.norm()) * maxCurvature(car) + kTolerance) << i;
    ASSERT_LE(turn, 0.1 * car.max_turn_per_step + kTolerance) << i;
    heading = bearing({0.0, 0.0}, way);
    last_length = 1.001 * way.norm();
  }
}

class CarEpisode : public testing::TestWithParam<std::pair<const char*, const char*>> {};

TEST_P(CarEpisode, EndsSafelyAtTheGoalOnArcs) {
  const World world = loadShipped(GetParam().first);
  EpisodeParams params = loadParams("paper_car", 60);
  params.navigation.planner = GetParam().second;
  const EpisodeResult result = runEpisode(world, params);
  EXPECT_EQ(result.end, EpisodeEnd::kGoalReached) << describe(result.end);
  EXPECT_EQ(result.metrics.unsafe_steps, 0);
  EXPECT_EQ(result.bound_violations, 0);
  EXPECT_GE(result.metrics.travel_time, 29.0);
  EXPECT_LT(result.metrics.travel_time, 80.0);
  EXPECT_LE(result.metrics.max_speed, 4.0 + 1e-9);
  expectDrivenByACar(result.trail, world.start.heading, params.navigation.planning.model.vehicle);
  const EpisodeResult again = runEpisode(world, params);
  ASSERT_EQ(result.trail.size(), again.trail.size());
  for (size_t i = 0; i < again.trail.size(); ++i) ASSERT_EQ(result.trail[i], again.trail[i]) << i;
}

INSTANTIATE_TEST_SUITE_P(EveryWorld, CarEpisode,
                         testing::Values(std::make_pair("scenario_1", "2d_nhv"),
                                         std::make_pair("scenario_2", "2d_nhv_fm2"),
                                         std::make_pair("scenario_3", "2d_nhv_fm2")),
                         [](const auto& test) { return std::string(test.param.first); });

TEST(Episode, IsReproducibleBitForBit) {
  const World world = loadShipped("scenario_2");
  EpisodeParams params = loadParams("paper", 60);
  params.time_limit = 25.0;
  const EpisodeResult first = runEpisode(world, params);
  const EpisodeResult second = runEpisode(world, params);
  ASSERT_EQ(first.trail.size(), second.trail.size());
  for (size_t i = 0; i < first.trail.size(); ++i) ASSERT_EQ(first.trail[i], second.trail[i]) << i;
  EXPECT_EQ(first.metrics.min_moving_distance, second.metrics.min_moving_distance);
  params.seed = 2;
  const EpisodeResult other = runEpisode(world, params);
  EXPECT_NE(first.metrics.min_moving_distance, other.metrics.min_moving_distance);
}

TEST(Episode, ARealBaseKeepsItsLimitsAtEveryTick) {
  const World world = loadShipped("scenario_1");
  EpisodeParams params = loadParams("movo", 20);
  const EpisodeResult result = runEpisode(world, params);
  EXPECT_EQ(result.end, EpisodeEnd::kGoalReached) << describe(result.end);
  EXPECT_EQ(result.metrics.unsafe_steps, 0);
  EXPECT_EQ(result.bound_violations, 0);
  constexpr double kTick = 0.1;  // [s]
  const double max_speed = params.navigation.planning.model.vehicle.max_speed;
  // 1 m/s^2 along and across.
  const double max_change = std::sqrt(2.0) * 1.0 * kTick;
  Point last_velocity(0.0, 0.0);
  for (size_t i = 1; i < result.trail.size(); ++i) {
    const Point velocity = (result.trail[i] - result.trail[i - 1]) / kTick;
    ASSERT_LE(velocity.norm(), max_speed + 1e-6) << "tick " << i;
    ASSERT_LE((velocity - last_velocity).norm(), max_change + 1e-6) << "tick " << i;
    last_velocity = velocity;
  }
}

TEST(Episode, ObserversSeeEveryDecision) {
  const World world = loadShipped("scenario_1");
  EpisodeParams params = loadParams("paper", 10);
  params.time_limit = 8.0;
  std::vector<double> times;
  const EpisodeResult result = runEpisode(world, params, [&](const EpisodeMoment& moment) {
    times.push_back(moment.time);
    const Point& robot = moment.simulator.base().pose().position;
    EXPECT_LT((moment.decision.plan.front().position - robot).norm(), 1e-4);
  });
  EXPECT_EQ(result.end, EpisodeEnd::kTimeLimit);
  EXPECT_EQ(static_cast<int>(times.size()), result.metrics.decisions);
  ASSERT_GE(times.size(), 3U);
  EXPECT_NEAR(times[0], 1.0, 1e-9);
  EXPECT_NEAR(times[1], 2.0, 1e-9);
}

TEST(Episode, TheEndHasAName) {
  EXPECT_STREQ(describe(EpisodeEnd::kGoalReached), "goal reached");
  EXPECT_STREQ(describe(EpisodeEnd::kTimeLimit), "time limit");
  EXPECT_STREQ(describe(EpisodeEnd::kLeftField), "left the field");
  EXPECT_STREQ(describe(EpisodeEnd::kHitObstacle), "hit an obstacle");
}

TEST(Episode, AnUnknownPlannerIsRefused) {
  EpisodeParams params = loadParams("paper", 1);
  params.navigation.planner = "none";
  EXPECT_THROW(runEpisode(loadShipped("scenario_1"), params), std::invalid_argument);
}

}  // namespace
}  // namespace pomdp_crowd_nav
