// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/evaluation/prediction_score.h"

#include <gtest/gtest.h>

#include <cmath>

#include "../recordings.h"
#include "pomdp_crowd_nav/evaluation/destination_learning.h"
#include "pomdp_crowd_nav/params/load_params.h"
#include "pomdp_crowd_nav/params/yaml_param_reader.h"
#include "pomdp_crowd_nav/sim/world_file.h"

namespace pomdp_crowd_nav {
namespace {

// One person walks to the right at 1 m/s for 9 s, one stands; a sweep every 0.5 s.
std::vector<TrackSample> walkerAndStander() {
  std::vector<TrackSample> recording;
  for (int i = 0; i <= 18; ++i) {
    recording.push_back({0.5 * i, 1, {0.5 * i, 0.0}});
    recording.push_back({0.5 * i, 2, {20.0, 10.0}});
  }
  return recording;
}

PredictionParams exact() {
  PredictionParams params;
  params.pedestrian_noise = 0.0;
  params.horizons = 2;
  params.scenarios = 10;
  params.history = 1.0;
  return params;
}

const Bounds kField{{-10.0, -20.0}, {110.0, 20.0}};

TEST(PredictionScore, OfFuturesThatComeTrue) {
  // One destination, straight ahead of who walks: the futures are exact.
  const auto scores = scorePredictions(walkerAndStander(), {{100.0, 0.0}}, kField, exact());
  ASSERT_EQ(scores.size(), 2U);
  EXPECT_EQ(scores[0].horizon, 1.0);
  EXPECT_EQ(scores[0].all.count, 2 * 15) << "sweeps from 1 s to 8 s";
  EXPECT_EQ(scores[1].all.count, 2 * 13);
  EXPECT_EQ(scores[0].slow.count, 15);
  // Who stands is taken to walk 1 m in the first second, 2 m in two.
  EXPECT_NEAR(scores[0].slow.error, 1.0, 1e-4);
  EXPECT_NEAR(scores[1].slow.error, 2.0, 1e-4);
  EXPECT_EQ(scores[0].slow.near_share, 0.0);
  EXPECT_NEAR(scores[0].all.error, 0.5, 1e-4);
  EXPECT_NEAR(scores[0].all.near_share, 0.5, 1e-12);
  // A kernel of 0.3 m has the density 1 / (2 pi 0.09) in the middle, and that times
  // exp(-1 / 0.18) 1 m off; the field has 4800 m^2.
  const double peak = 1.0 / (2.0 * M_PI * 0.09);
  const double hit = std::log(0.99 * peak + 0.01 / 4800.0);
  const double missed = std::log(0.99 * peak * std::exp(-1.0 / 0.18) + 0.01 / 4800.0);
  EXPECT_NEAR(scores[0].all.log_density, 0.5 * (hit + missed), 1e-3);
  const PredictionScores both = overall(scores);
  EXPECT_EQ(both.slow.count, 28);
  EXPECT_NEAR(both.slow.error, (15 * 1.0 + 13 * 2.0) / 28.0, 1e-4);
}

TEST(PredictionScore, OfABeliefThatKnowsStanding) {
  PredictionParams params = exact();
  params.belief.expect_elsewhere = true;
  const auto scores = scorePredictions(walkerAndStander(), {{100.0, 0.0}}, kField, params);
  EXPECT_LT(scores[1].slow.error, 0.7) << "2 m without";
  EXPECT_LT(scores[1].all.error, 0.6);
}

TEST(PredictionScore, IsReproducible) {
  PredictionParams params = exact();
  params.pedestrian_noise = 0.2;
  const auto one = scorePredictions(walkerAndStander(), {{100.0, 0.0}}, kField, params);
  const auto two = scorePredictions(walkerAndStander(), {{100.0, 0.0}}, kField, params);
  EXPECT_EQ(one[0].all.log_density, two[0].all.log_density);
}

void print(const std::string& name, const std::vector<PredictionScores>& scores) {
  for (const PredictionScores& one : scores) {
    for (const auto& [who, s] : {std::pair("all", one.all), std::pair("slow", one.slow)}) {
      printf("| %s | %.0f | %s | %ld | %.3f | %.3f | %.3f |\n", name.c_str(), one.horizon, who,
             s.count, s.log_density, s.error, s.near_share);
    }
  }
}

struct Recorded {
  std::string name;
  World world;
  std::vector<TrackSample> tracks;
  PredictionParams params;  // of the profile street

  PredictionScores score(const std::string& what, bool expect_elsewhere,
                         const std::vector<Point>& destinations) {
    params.belief.expect_elsewhere = expect_elsewhere;
    const auto scores = scorePredictions(tracks, destinations, world.bounds, params);
    print(name + " | " + what, scores);
    return overall(scores);
  }
};

std::vector<Recorded> recordings() {
  std::vector<Recorded> all;
  for (const std::string name : {"ucy_students03", "ucy_zara01"}) {
    const std::string path = recordingPath(name + ".csv");
    if (!isThere(path)) continue;
    auto reader = YamlParamReader::fromFile(SOURCE_DIR "/config/profiles/street.yaml");
    Recorded one{
        name, loadWorld(SOURCE_DIR "/config/worlds/" + name + ".yaml"), readTracksFile(path), {}};
    const NavigationParams navigation = loadNavigationParams(reader);
    one.params.belief = navigation.belief;
    one.params.pedestrian_noise = navigation.planning.model.pedestrian_noise;
    all.push_back(std::move(one));
  }
  return all;
}

// Figures in doc/measurements.md; the margins are about half of what was measured there.
TEST(PredictionScore, StandingAndElsewhereForetellRecordedPeopleBetter) {
  std::vector<Recorded> all = recordings();
  if (all.size() < 2) GTEST_SKIP() << "recordings are absent; set UCY_DATA_DIR to their folder";
  for (Recorded& recorded : all) {
    const std::vector<Point>& destinations = recorded.world.destinations;
    const PredictionScores paper = recorded.score("the paper's rule", false, destinations);
    const PredictionScores here = recorded.score("standing, elsewhere", true, destinations);
    EXPECT_GT(here.all.log_density, paper.all.log_density + 0.4) << recorded.name;
    EXPECT_LT(here.all.error, 0.8 * paper.all.error) << recorded.name;
    EXPECT_GT(here.all.near_share, paper.all.near_share + 0.05) << recorded.name;
    const bool has_groups = recorded.name == "ucy_students03";  // many who stand and talk
    EXPECT_GT(here.slow.log_density, paper.slow.log_density + (has_groups ? 0.15 : -0.1));
    EXPECT_LT(here.slow.error, (has_groups ? 0.92 : 1.02) * paper.slow.error) << recorded.name;
  }
}

TEST(PredictionScore, LearnedDestinationsAreAsGoodAsThoseOfTheWorlds) {
  std::vector<Recorded> all = recordings();
  if (all.size() < 2) GTEST_SKIP() << "recordings are absent; set UCY_DATA_DIR to their folder";
  for (Recorded& recorded : all) {
    std::vector<Point> learned;
    for (const auto& one : learnDestinations(recorded.tracks, {}).destinations) {
      learned.push_back(one.position);
    }
    for (const bool elsewhere : {false, true}) {
      const PredictionScores before =
          recorded.score("of the world", elsewhere, recorded.world.destinations);
      const PredictionScores here = recorded.score("learned", elsewhere, learned);
      EXPECT_GT(here.all.log_density, before.all.log_density - 0.05) << recorded.name;
    }
  }
}

}  // namespace
}  // namespace pomdp_crowd_nav
