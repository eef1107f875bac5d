// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

#include "pomdp_crowd_nav/evaluation/paper_results.h"
#include "pomdp_crowd_nav/evaluation/results_file.h"
#include "pomdp_crowd_nav/evaluation/statistics.h"

namespace pomdp_crowd_nav {

// Whose times the other planners' are compared with.
inline constexpr const char* kBaselinePlanner = "1d_astar";

// The episodes of one planner among one number of people in one world.
struct Cell {
  std::string world;
  int pedestrians = 0;
  std::string planner;
  std::vector<const EpisodeRow*> episodes;
};

// In the order in which they appear.
std::vector<Cell> cellsOf(const std::vector<EpisodeRow>& rows);

// What is said of a cell. As in the authors' code, means are over the episodes that arrived
// without an unsafe tick.
struct CellSummary {
  int episodes = 0;
  int arrived = 0;
  Summary travel_time;  // [s]
  Summary sudden_brakes;
  int unsafe_episodes = 0;  // moving within 1 m of somebody (paper)
  std::int64_t unsafe_steps = 0;
  int risky_episodes = 0;  // moving within 0.5 m (the authors' code)
  std::int64_t unsafe_ticks = 0;
  double min_distance = 0.0;      // [m], infinite where nobody came near
  double mean_search_time = 0.0;  // [s], of all decisions' means
  double max_search_time = 0.0;   // [s]
  double mean_trials = 0.0;
  std::int64_t bound_violations = 0;
  double stale_share = 0.0;  // of decisions without a fresh path; NaN where it was not counted
};
CellSummary summarize(const Cell& cell);

// Two planners among the same people: episodes of the same seed, where both count.
struct Pairs {
  int count = 0;
  int won = 0;         // in which the planner was faster
  Summary difference;  // [s], planner less baseline
  Summary reduction;   // share of the baseline's time
};
Pairs comparePairs(const Cell& cell, const Cell& baseline);

// How far from what was possible.
struct BoundDistance {
  Summary difference;  // [s], travel time less bound
  Summary ratio;       // travel time over bound
};
// Against the omniscient plan and against the drive without people.
struct BoundDistances {
  BoundDistance plan;
  BoundDistance free_drive;
};
// `max_speed` [mm/s] of the robot.
BoundDistances compareWithBounds(const Cell& cell, const BoundsOfTrips& bounds, long max_speed);

// Everything in Markdown, a section for each results file.
std::string writeReport(const std::vector<ResultsFile>& files, const PaperResults& paper,
                        const BoundsOfTrips& bounds);

}  // namespace pomdp_crowd_nav
