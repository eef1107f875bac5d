// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/evaluation/experiment.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <map>
#include <memory>
#include <stdexcept>
#include <thread>

#include "pomdp_crowd_nav/params/yaml_param_reader.h"
#include "pomdp_crowd_nav/sim/world_file.h"

namespace pomdp_crowd_nav {
namespace {

std::vector<Trial> someTrials(int count) {
  ExperimentPlan plan;
  plan.worlds = {"w"};
  plan.pedestrians = {10};
  plan.planners = {"p"};
  plan.runs = count;
  return plan.trials();
}

// The travel time tells which trial a result is of.
EpisodeResult resultOf(const Trial& trial) {
  EpisodeResult result;
  result.metrics.travel_time = static_cast<double>(trial.seed);
  return result;
}

TEST(ExperimentPlan, RunsAllCombinationsSeedsInnermost) {
  ExperimentPlan plan;
  plan.worlds = {"a", "b"};
  plan.pedestrians = {10, 20};
  plan.planners = {"p", "q", "r"};
  plan.runs = 2;
  plan.first_seed = 7;
  const std::vector<Trial> trials = plan.trials();
  ASSERT_EQ(trials.size(), 24U);
  EXPECT_EQ(trials[0].world, "a");
  EXPECT_EQ(trials[0].pedestrians, 10);
  EXPECT_EQ(trials[0].planner, "p");
  EXPECT_EQ(trials[0].seed, 7U);
  EXPECT_EQ(trials[1].seed, 8U);
  EXPECT_EQ(trials[2].planner, "q");
  EXPECT_EQ(trials[2].seed, 7U) << "every planner meets the same people";
  EXPECT_EQ(trials[6].pedestrians, 20);
  EXPECT_EQ(trials[23].world, "b");
  EXPECT_EQ(trials[23].planner, "r");
  EXPECT_EQ(trials[23].seed, 8U);
}

TEST(RunTrials, DeliversEveryResultOnceWithItsTrialWhateverTheNumberOfJobs) {
  const std::vector<Trial> trials = someTrials(40);
  for (const int jobs : {1, 2, 7, 64}) {
    std::vector<size_t> delivered;
    std::atomic<int> inside{0};
    runTrials(
        trials, jobs,
        [](const Trial& trial) {
          // Later trials end first.
          std::this_thread::sleep_for(std::chrono::microseconds(trial.seed % 5 == 0 ? 3000 : 10));
          return resultOf(trial);
        },
        [&](size_t index, const EpisodeResult& result) {
          EXPECT_EQ(++inside, 1) << "one call at a time";
          EXPECT_EQ(result.metrics.travel_time, static_cast<double>(trials[index].seed));
          delivered.push_back(index);
          --inside;
        });
    const bool in_order = std::is_sorted(delivered.begin(), delivered.end());
    EXPECT_TRUE(in_order || jobs > 1);
    std::sort(delivered.begin(), delivered.end());
    ASSERT_EQ(delivered.size(), 40U) << jobs;
    for (size_t i = 0; i < delivered.size(); ++i) EXPECT_EQ(delivered[i], i) << jobs;
  }
}

// A slow episode keeps nobody else's result waiting, who might be killed meanwhile.
TEST(RunTrials, DeliversAResultAsSoonAsItIsThere) {
  std::atomic<bool> second_is_there{false};
  bool first_has_seen_it = false;
  runTrials(
      someTrials(2), 2,
      [&](const Trial& trial) {
        if (trial.seed == 1) {
          for (int i = 0; i < 5000 && !second_is_there; ++i) {
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
          }
          first_has_seen_it = second_is_there;
        }
        return resultOf(trial);
      },
      [&](size_t index, const EpisodeResult&) {
        if (index == 1) second_is_there = true;
      });
  EXPECT_TRUE(first_has_seen_it);
}

TEST(RunTrials, RunsTrialsAtOnce) {
  std::atomic<int> running{0};
  std::atomic<int> most{0};
  runTrials(
      someTrials(8), 4,
      [&](const Trial& trial) {
        const int now = ++running;
        int before = most;
        while (before < now && !most.compare_exchange_weak(before, now)) {
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
        --running;
        return resultOf(trial);
      },
      [](size_t, const EpisodeResult&) {});
  EXPECT_GT(most, 1);
  EXPECT_LE(most, 4);
}

TEST(RunTrials, AFailureStopsTheRestAndIsThrownOn) {
  for (const int jobs : {1, 4}) {
    std::vector<std::uint64_t> delivered;
    std::atomic<int> started{0};
    std::string message;
    try {
      runTrials(
          someTrials(1000), jobs,
          [&](const Trial& trial) {
            ++started;
            if (trial.seed == 4) throw std::runtime_error("trial 4 failed");
            std::this_thread::sleep_for(std::chrono::microseconds(200));
            return resultOf(trial);
          },
          [&](size_t index, const EpisodeResult&) { delivered.push_back(index + 1); });
    } catch (const std::runtime_error& error) {
      message = error.what();
    }
    EXPECT_EQ(message, "trial 4 failed");
    EXPECT_LT(started, 500);
    std::sort(delivered.begin(), delivered.end());
    ASSERT_GE(delivered.size(), 3U) << "with " << jobs << " jobs";
    delivered.resize(3);
    EXPECT_EQ(delivered, (std::vector<std::uint64_t>{1, 2, 3})) << "with " << jobs << " jobs";
  }
}

TEST(RunTrials, AFailingSinkStopsTheExperiment) {
  EXPECT_THROW(runTrials(someTrials(10), 2, resultOf,
                         [](size_t, const EpisodeResult&) { throw std::runtime_error("disk"); }),
               std::runtime_error);
}

TEST(RunTrials, ASinkThatHasFailedReceivesNothingMore) {
  for (int round = 0; round < 20; ++round) {
    std::atomic<int> calls{0};
    std::atomic<int> ended{0};
    const auto runner = [&](const Trial& trial) {
      // The second result is there before the first one is delivered.
      for (++ended; ended < 2;) std::this_thread::yield();
      return resultOf(trial);
    };
    EXPECT_THROW(runTrials(someTrials(50), 4, runner,
                           [&](size_t, const EpisodeResult&) {
                             if (++calls == 1) throw std::runtime_error("disk");
                           }),
                 std::runtime_error);
    EXPECT_EQ(calls, 1);
  }
}

TEST(RunTrials, NothingToDoIsFine) {
  EXPECT_NO_THROW(runTrials({}, 3, resultOf, [](size_t, const EpisodeResult&) { FAIL(); }));
}

TEST(RunTrials, RunsWithoutAJobToo) {
  int delivered = 0;
  runTrials(someTrials(3), 0, resultOf, [&](size_t, const EpisodeResult&) { ++delivered; });
  EXPECT_EQ(delivered, 3);
}

TEST(Csv, ARowHasACellForEveryColumn) {
  EpisodeResult result;
  result.end = EpisodeEnd::kGoalReached;
  result.metrics.travel_time = 66.0;
  result.metrics.path_length = 112.3456;
  result.metrics.min_moving_distance = 1.25;
  result.metrics.sudden_brakes = 2;
  result.metrics.unsafe_steps = 3;
  result.metrics.unsafe_ticks = 4;
  result.mean_search_time = 0.0123456;
  result.max_search_time = 0.05;
  result.mean_trials = 200.0;
  result.bound_violations = 5;
  result.metrics.decisions = 65;
  result.stale_paths = 6;
  const std::string row = csvRow({"scenario_1", 100, "2d_fmm", 7}, result);
  EXPECT_EQ(row,
            "scenario_1,100,2d_fmm,7,1,66.000,2,1.250,3,4,112.346,0.012346,0.050000,200.0,5,65,6");
  const std::string header = csvHeader();
  EXPECT_EQ(std::count(header.begin(), header.end(), ','), std::count(row.begin(), row.end(), ','));
}

TEST(Csv, WhatWasNotMeasuredStaysEmpty) {
  EpisodeResult result;
  const std::string row = csvRow({"w", 0, "p", 1}, result);
  EXPECT_EQ(row, "w,0,p,1,0,0.000,0,,0,0,0.000,0.000000,0.000000,0.0,0,0,0");
}

TEST(Csv, ATrailHasTheStartAndAPlaceForEachStep) {
  EpisodeResult result;
  for (int tick = 1; tick <= 8; ++tick) result.trail.emplace_back(0.5 * tick, 2.0);
  EXPECT_EQ(trailRows({"w", 3, "p", 1}, {0.0, 2.0}, 0.4, result),
            "w,3,p,1,0.00,0.00,2.00\nw,3,p,1,0.40,2.00,2.00\nw,3,p,1,0.80,4.00,2.00\n");
}

TEST(Episode, EveryPlannerMeetsTheSamePeople) {
  auto reader = YamlParamReader::fromFile(SOURCE_DIR "/config/profiles/paper.yaml");
  EpisodeParams params;
  params.navigation = loadNavigationParams(reader);
  params.simulator = loadSimulatorParams(reader, params.navigation.planning.model.vehicle);
  params.simulator.pedestrians = 60;
  params.max_trials = 2;
  params.time_limit = 30.0;
  params.seed = 5;
  const World world = loadWorld(SOURCE_DIR "/config/worlds/scenario_1.yaml");
  std::map<std::string, std::vector<std::vector<Walker>>> met;
  for (const char* planner : {"2d_straight", "2d_fmm"}) {
    params.navigation.planner = planner;
    runEpisode(world, params, [&](const EpisodeMoment& moment) {
      met[planner].push_back(moment.simulator.crowd().walkers());
    });
  }
  const auto& others = met["2d_fmm"];
  ASSERT_GE(others.size(), 25U);
  ASSERT_EQ(met["2d_straight"].size(), others.size());
  for (size_t i = 0; i < others.size(); ++i) {
    ASSERT_EQ(met["2d_straight"][i].size(), others[i].size());
    for (size_t j = 0; j < others[i].size(); ++j) {
      ASSERT_EQ(met["2d_straight"][i][j].id, others[i][j].id);
      ASSERT_EQ(met["2d_straight"][i][j].position, others[i][j].position) << i;
    }
  }
}

TEST(Episode, SharedTablesChangeNothing) {
  auto reader = YamlParamReader::fromFile(SOURCE_DIR "/config/profiles/paper.yaml");
  EpisodeParams params;
  params.navigation = loadNavigationParams(reader);
  params.simulator = loadSimulatorParams(reader, params.navigation.planning.model.vehicle);
  params.simulator.pedestrians = 30;
  params.max_trials = 5;
  const World world = loadWorld(SOURCE_DIR "/config/worlds/scenario_2.yaml");
  const EpisodeResult alone = runEpisode(world, params);
  params.tables = std::make_shared<SharedTables>();
  for (int i = 0; i < 2; ++i) {
    const EpisodeResult shared = runEpisode(world, params);
    ASSERT_EQ(shared.trail.size(), alone.trail.size());
    for (size_t k = 0; k < alone.trail.size(); ++k) ASSERT_EQ(shared.trail[k], alone.trail[k]);
  }
}

}  // namespace
}  // namespace pomdp_crowd_nav
