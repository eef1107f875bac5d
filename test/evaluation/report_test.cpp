// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/evaluation/report.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "../sim/temporary_file.h"

namespace pomdp_crowd_nav {
namespace {

const std::string kHeader =
    "world,pedestrians,planner,seed,reached,travel_time_s,sudden_brakes,min_moving_distance_m,"
    "unsafe_steps_1m,unsafe_ticks_0_5m,path_length_m,mean_search_time_s,max_search_time_s,"
    "mean_trials,lower_bound_violations\n";

std::string row(const std::string& planner, int seed, double time, const char* safety = "1.5,0,0",
                int reached = 1) {
  return fmt::format("scenario_1,100,{},{},{},{},{},{},110.0,0.010,0.020,200.0,0\n", planner, seed,
                     reached, time, seed % 2, safety);
}

std::string failure(const std::string& text) {
  const TemporaryFile file("file.csv", text);
  try {
    readResults(file.path());
  } catch (const std::runtime_error& error) {
    const std::string message = error.what();
    EXPECT_EQ(message.rfind(file.path() + ":", 0), 0U) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    return message.substr(file.path().size());
  }
  return "";
}

const std::string kPairs = kHeader + row("1d_astar", 1, 80.0) + row("1d_astar", 2, 70.0) +
                           row("1d_astar", 3, 90.0) + row("2d_fmm", 1, 60.0) +
                           row("2d_fmm", 2, 70.0) + row("2d_fmm", 3, 72.0) + row("2d_fmm", 4, 61.0);

TEST(Results, AreReadByTheNamesOfTheColumns) {
  const TemporaryFile file(
      "file.csv",
      "stale_paths,seed,planner,pedestrians,world,reached,travel_time_s,sudden_brakes,more,"
      "min_moving_distance_m,unsafe_steps_1m,unsafe_ticks_0_5m,mean_search_time_s,"
      "max_search_time_s,mean_trials,lower_bound_violations,decisions\n"
      "3,9,p,100,w,1,60.5,2,x,,4,5,0.25,0.5,150.5,6,30\n");
  const ResultsFile results = readResults(file.path());
  ASSERT_EQ(results.rows.size(), 1U);
  const EpisodeRow& row = results.rows[0];
  EXPECT_EQ(row.trial.world, "w");
  EXPECT_EQ(row.trial.pedestrians, 100);
  EXPECT_EQ(row.trial.planner, "p");
  EXPECT_EQ(row.trial.seed, 9U);
  EXPECT_TRUE(row.reached);
  EXPECT_EQ(row.travel_time, 60.5);
  EXPECT_EQ(row.sudden_brakes, 2);
  EXPECT_FALSE(row.min_moving_distance);
  EXPECT_EQ(row.unsafe_steps, 4);
  EXPECT_EQ(row.unsafe_ticks, 5);
  EXPECT_EQ(row.mean_trials, 150.5);
  EXPECT_EQ(row.bound_violations, 6);
  EXPECT_EQ(row.decisions, 30);
  EXPECT_EQ(row.stale_paths, 3);
}

TEST(Results, WhatIsWrongIsNamedWithItsLine) {
  EXPECT_EQ(failure(""), ":1: expected a header, the file is empty");
  EXPECT_EQ(failure(kHeader), ":2: expected a row, there is none");
  EXPECT_EQ(failure("world,seed\nw,1\n"), ":1: there is no column 'pedestrians'");
  EXPECT_EQ(failure(kHeader + row("p", 1, 60.0) + "w,100,p\n"),
            ":3: expected 15 cells as in the header, got 3");
  std::string text = row("p", 1, 60.0);
  text.replace(text.find("60"), 2, "soon");
  EXPECT_EQ(failure(kHeader + text), ":2: travel_time_s: expected a number, got 'soon'");
  EXPECT_EQ(failure(kHeader + row("p", 1, 60.0) + row("p", 1, 61.0)),
            ":3: the episode 'scenario_1,100,p,1,' is there twice");
  EXPECT_EQ(failure(kHeader + row("p", 1, 60.0, "1.5,-1,0")),
            ":2: unsafe_steps_1m: expected a whole number, at least 0, got '-1'");
  EXPECT_EQ(failure(kHeader + row("p", 1, 60.0, "1.5,0,0", 2)), ":2: reached: expected 0 or 1");
}

TEST(Report, PairsAreEpisodesOfTheSameSeed) {
  const TemporaryFile file("file.csv", kPairs);
  const ResultsFile results = readResults(file.path());
  const std::vector<Cell> cells = cellsOf(results.rows);
  ASSERT_EQ(cells.size(), 2U);
  const Pairs pairs = comparePairs(cells[1], cells[0]);
  EXPECT_EQ(pairs.count, 3);
  EXPECT_EQ(pairs.won, 2) << "as fast is not faster";
  EXPECT_NEAR(pairs.difference.mean, (-20.0 + 0.0 - 18.0) / 3.0, 1e-12);
  EXPECT_NEAR(pairs.reduction.mean, (0.25 + 0.0 + 0.2) / 3.0, 1e-12);
  const CellSummary summary = summarize(cells[1]);
  EXPECT_EQ(summary.arrived, 4);
  EXPECT_NEAR(summary.travel_time.mean, (60.0 + 70.0 + 72.0 + 61.0) / 4.0, 1e-12);
}

TEST(Report, MeansLeaveOutWhoDidNotArriveOrWasUnsafeByTheCodesRule) {
  const TemporaryFile file("file.csv",
                           kHeader + row("p", 1, 60.0) + row("p", 2, 301.0, "1.5,0,0", 0) +
                               row("p", 3, 50.0, "0.4,2,3") + row("p", 4, 64.0, "0.9,1,0"));
  const ResultsFile results = readResults(file.path());
  const CellSummary summary = summarize(cellsOf(results.rows)[0]);
  EXPECT_EQ(summary.episodes, 4);
  EXPECT_EQ(summary.arrived, 3);
  EXPECT_EQ(summary.travel_time.count, 2);
  EXPECT_NEAR(summary.travel_time.mean, 62.0, 1e-12);
  EXPECT_EQ(summary.unsafe_episodes, 2);
  EXPECT_EQ(summary.unsafe_steps, 3);
  EXPECT_EQ(summary.risky_episodes, 1);
  EXPECT_EQ(summary.unsafe_ticks, 3);
  EXPECT_DOUBLE_EQ(summary.min_distance, 0.4);
  EXPECT_TRUE(std::isnan(summary.stale_share));
  const std::string text = writeReport({results}, {}, {});
  EXPECT_NE(text.find("3 of 4:"), std::string::npos) << text;
  EXPECT_NE(text.find("| scenario_1 | 100 | p | 2 | time limit | 301.0 | 0 | 0 | 1.500 |"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("| 3 | too close to somebody | 50.0 | 2 | 3 | 0.400 |"), std::string::npos);
  EXPECT_NE(text.find("3 of 4 episodes arrived. Unsafe were 2 by"), std::string::npos);
}

TEST(Report, PutsThePapersFiguresBesideOurs) {
  const TemporaryFile file("file.csv", kPairs);
  const PaperResults paper = PaperResults::fromFile(SOURCE_DIR "/config/paper_results.yaml");
  const std::string text = writeReport({readResults(file.path())}, paper, {});
  EXPECT_NE(text.find("holonomic vehicle"), std::string::npos);
  EXPECT_NE(text.find("| scenario_1 | 100 | 2d_fmm | 65.75 ± 3.07 | 64.04 ± 0.37 | 2 of 3 | 99 of "
                      "100 | 0.50 ± 0.29 | 0.21 ± 0.04 |"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("| scenario_1 | 100 | 1d_astar | 80.00 ± 5.77 | 77.02 ± 0.69 | – | – |"),
            std::string::npos)
      << text;
  // t(0.975, 2) = 4.30265; the deviation of -20, 0, -18 is 11.015.
  EXPECT_NE(text.find("| 3 | -12.67 [-40.03, +14.70] |"), std::string::npos) << text;
}

TEST(Report, ACarHasRowsOfItsOwn) {
  const TemporaryFile file("file.csv", kHeader + row("1d_astar", 1, 50.0) + row("2d_nhv", 1, 36.0));
  const PaperResults paper = PaperResults::fromFile(SOURCE_DIR "/config/paper_results.yaml");
  const std::string text = writeReport({readResults(file.path())}, paper, {});
  EXPECT_NE(text.find(": car\n"), std::string::npos);
  EXPECT_NE(text.find("53.62 ± 0.91"), std::string::npos) << text;
  EXPECT_EQ(text.find("77.02"), std::string::npos) << "that of the holonomic vehicle";
}

TEST(Report, TheSettingsNameTheVehicle) {
  const TemporaryFile file("file.csv", kHeader + row("1d_astar", 1, 50.0));
  ExperimentSettings settings;
  settings.plan.worlds = {"scenario_1"};
  settings.max_trials = 300;
  settings.worlds["scenario_1"] = {"paper_car", "car", {{"max_vel_trans", "4.0"}}, {}, ""};
  ResultsFile results = readResults(file.path());
  results.settings = settings;
  const BoundsOfTrips bounds = {{{"scenario_1", 100, 1, 4000}, {40.0, 25.0}},
                                {{"scenario_1", 100, 1, 2000}, {57.0, 56.0}}};
  const std::string text = writeReport({results}, {}, bounds);
  EXPECT_NE(text.find(": car\n"), std::string::npos) << text;
  EXPECT_NE(text.find("Profile `paper_car`, at most 300 search trials"), std::string::npos) << text;
  EXPECT_NE(text.find("| 1d_astar | 1 | 10.00 | 1.250 | 1 | 25.00 | 2.000 |"), std::string::npos)
      << text;
}

TEST(Report, EachWorldHasTheVehicleAndTheSpeedOfItsProfile) {
  const auto rowIn = [](const std::string& world, double time) {
    return fmt::format("{},7,2d_fmm,1,1,{},0,1.5,0,0,110.0,0.010,0.020,200.0,0\n", world, time);
  };
  const TemporaryFile file("file.csv",
                           kHeader + rowIn("a_street", 30.0) + rowIn("scenario_1", 60.0));
  ResultsFile results = readResults(file.path());
  results.settings.emplace();
  results.settings->worlds["a_street"] = {
      "street", "holonomic", {{"max_vel_trans", "1.6"}}, {}, ""};
  results.settings->worlds["scenario_1"] = {"paper", "holonomic", {{"max_vel_trans", "2"}}, {}, ""};
  const BoundsOfTrips bounds = {{{"a_street", 7, 1, 1600}, {20.0, 15.0}},
                                {{"a_street", 7, 1, 2000}, {10.0, 10.0}},
                                {{"scenario_1", 7, 1, 1600}, {10.0, 10.0}},
                                {{"scenario_1", 7, 1, 2000}, {std::nullopt, 50.0}}};
  const std::string text = writeReport({results}, {}, bounds);
  EXPECT_NE(text.find("| a_street | 7 | 2d_fmm | 1 | 10.00 | 1.500 | 1 | 15.00 | 2.000 |"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("| scenario_1 | 7 | 2d_fmm | 0 | – | – | 1 | 10.00 | 1.200 |"),
            std::string::npos)
      << text;
}

TEST(Report, OtherPlannersAndWorldsNeedNoPaper) {
  const TemporaryFile file("file.csv",
                           kHeader + "yard,7,mine,1,1,30.0,0,,0,0,40.0,0.01,0.02,10.0,0\n");
  const PaperResults paper = PaperResults::fromFile(SOURCE_DIR "/config/paper_results.yaml");
  const std::string text = writeReport({readResults(file.path())}, paper, {});
  EXPECT_NE(text.find("| world | people | planner | travel time [s] | sudden brakes |"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("| yard | 7 | mine | 30.00 | 0.00 |"), std::string::npos) << text;
}

TEST(PaperResults, HoldAllCellsOfBothTables) {
  const PaperResults paper = PaperResults::fromFile(SOURCE_DIR "/config/paper_results.yaml");
  int cells = 0;
  for (const char* vehicle : {"holonomic", "car"}) {
    for (const char* planner : {"1d_astar", "2d_fmm", "2d_prm", "2d_nhv"}) {
      for (const char* world : {"scenario_1", "scenario_2", "path/to/scenario_3.yaml"}) {
        for (const int people : {100, 200, 300, 400}) {
          const auto cell = paper.find(vehicle, planner, world, people);
          if (!cell) continue;
          ++cells;
          EXPECT_EQ(cell->pairs_won.has_value(), planner != std::string("1d_astar"));
        }
      }
    }
  }
  EXPECT_EQ(cells, 36 + 8);
  EXPECT_EQ(paper.find("holonomic", "2d_prm", "scenario_3", 400)->travel_time, 95.87);
}

TEST(Bounds, AreReadOncePerTrip) {
  const std::string header = "world,pedestrians,seed,max_speed_mps,bound_s,free_drive_s\n";
  const TemporaryFile file("file.csv", header + "w,10,1,2.000,57.2,56.9\nw,10,2,2.000,,56.9\n");
  const auto bounds = readBounds({file.path()});
  ASSERT_EQ(bounds.size(), 2U);
  EXPECT_EQ(bounds.at({"w", 10, 1, 2000}).plan, 57.2);
  EXPECT_EQ(bounds.at({"w", 10, 1, 2000}).free_drive, 56.9);
  EXPECT_FALSE(bounds.at({"w", 10, 2, 2000}).plan) << "none was found";
  for (const char* row :
       {"w,10,1,2,0,56\n", "w,10,1,2,57,-1\n", "w,10,1,2,57,\n", "w,10,1,2,57\n"}) {
    const TemporaryFile bad("bad.csv", header + row);
    EXPECT_THROW(readBounds({bad.path()}), std::runtime_error) << row;
  }
  const TemporaryFile twice("twice.csv", header + "w,10,1,2,57,56\nw,10,1,2,58,56\n");
  EXPECT_THROW(readBounds({twice.path()}), std::runtime_error);
}

}  // namespace
}  // namespace pomdp_crowd_nav
