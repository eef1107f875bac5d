// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "pomdp_crowd_nav/evaluation/experiment.h"
#include "pomdp_crowd_nav/evaluation/experiment_settings.h"

namespace pomdp_crowd_nav {

// A row of a results file (doc/tools.md).
struct EpisodeRow {
  Trial trial;
  bool reached = false;
  double travel_time = 0.0;  // [s]
  std::int64_t sudden_brakes = 0;
  std::optional<double> min_moving_distance;  // [m]
  std::int64_t unsafe_steps = 0;              // moving within 1 m (paper)
  std::int64_t unsafe_ticks = 0;              // moving within 0.5 m (the authors' code)
  double mean_search_time = 0.0;              // [s]
  double max_search_time = 0.0;               // [s]
  double mean_trials = 0.0;
  std::int64_t bound_violations = 0;
  // Where the file has these columns.
  std::optional<std::int64_t> decisions;
  std::optional<std::int64_t> stale_paths;
};

// A results file with its settings.
struct ResultsFile {
  std::string path;
  std::vector<EpisodeRow> rows;
  std::optional<ExperimentSettings> settings;  // where they are beside the file
};

// Both throw std::runtime_error with one line: file, line, and what is wrong. No episode may be in
// a file twice, and none in none of its rows.
ResultsFile readResults(const std::string& path);

// What was possible on a trip, of files that omniscient_bound wrote.
struct TripBounds {
  std::optional<double> plan;  // [s], of the omniscient plan, where one was found
  double free_drive = 0.0;     // [s], no trip takes less
};
// Which trip a bound belongs to.
struct TripKey {
  std::string world;
  int pedestrians = 0;
  std::uint64_t seed = 0;
  long max_speed = 0;  // [mm/s]

  bool operator<(const TripKey& other) const;
};
using BoundsOfTrips = std::map<TripKey, TripBounds>;
BoundsOfTrips readBounds(const std::vector<std::string>& paths);

}  // namespace pomdp_crowd_nav
