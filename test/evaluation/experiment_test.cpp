// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/evaluation/experiment.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <stdexcept>
#include <thread>

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

TEST(RunTrials, DeliversInOrderWhateverTheNumberOfJobs) {
  const std::vector<Trial> trials = someTrials(40);
  for (const int jobs : {1, 2, 7, 64}) {
    std::vector<std::uint64_t> delivered;
    std::atomic<int> inside{0};
    runTrials(
        trials, jobs,
        [](const Trial& trial) {
          // Later trials end first.
          std::this_thread::sleep_for(std::chrono::microseconds(trial.seed % 5 == 0 ? 3000 : 10));
          return resultOf(trial);
        },
        [&](const Trial& trial, const EpisodeResult& result) {
          EXPECT_EQ(++inside, 1) << "one call at a time";
          EXPECT_EQ(result.metrics.travel_time, static_cast<double>(trial.seed));
          delivered.push_back(trial.seed);
          --inside;
        });
    ASSERT_EQ(delivered.size(), 40U) << jobs;
    EXPECT_TRUE(std::is_sorted(delivered.begin(), delivered.end())) << jobs;
  }
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
      [](const Trial&, const EpisodeResult&) {});
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
          [&](const Trial& trial, const EpisodeResult&) { delivered.push_back(trial.seed); });
    } catch (const std::runtime_error& error) {
      message = error.what();
    }
    EXPECT_EQ(message, "trial 4 failed");
    EXPECT_LT(started, 500);
    EXPECT_EQ(delivered, (std::vector<std::uint64_t>{1, 2, 3})) << "with " << jobs << " jobs";
  }
}

TEST(RunTrials, AFailingSinkStopsTheExperiment) {
  EXPECT_THROW(
      runTrials(someTrials(10), 2, resultOf,
                [](const Trial&, const EpisodeResult&) { throw std::runtime_error("disk"); }),
      std::runtime_error);
}

TEST(RunTrials, NothingToDoIsFine) {
  EXPECT_NO_THROW(runTrials({}, 3, resultOf, [](const Trial&, const EpisodeResult&) { FAIL(); }));
}

TEST(RunTrials, RunsWithoutAJobToo) {
  int delivered = 0;
  runTrials(someTrials(3), 0, resultOf, [&](const Trial&, const EpisodeResult&) { ++delivered; });
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

}  // namespace
}  // namespace pomdp_crowd_nav
