// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/evaluation/results_file.h"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <set>
#include <stdexcept>
#include <tuple>

#include "pomdp_crowd_nav/evaluation/csv_table.h"

namespace pomdp_crowd_nav {
namespace {

EpisodeRow rowOf(const CsvTable& table, size_t row) {
  const auto count = [&](const char* name) { return table.count(row, table.column(name)); };
  const auto number = [&](const char* name) { return table.number(row, table.column(name)); };
  const auto countIfThere = [&](const char* name) -> std::optional<std::int64_t> {
    const auto column = table.findColumn(name);
    if (!column) return std::nullopt;
    return table.count(row, *column);
  };
  EpisodeRow episode;
  episode.trial.world = table.text(row, table.column("world"));
  episode.trial.pedestrians = static_cast<int>(count("pedestrians"));
  episode.trial.planner = table.text(row, table.column("planner"));
  episode.trial.seed = static_cast<std::uint64_t>(count("seed"));
  episode.reached = count("reached") == 1;
  if (count("reached") > 1) table.fail(row, "reached: expected 0 or 1");
  episode.travel_time = number("travel_time_s");
  episode.sudden_brakes = count("sudden_brakes");
  episode.min_moving_distance = table.numberOrNothing(row, table.column("min_moving_distance_m"));
  episode.unsafe_steps = count("unsafe_steps_1m");
  episode.unsafe_ticks = count("unsafe_ticks_0_5m");
  episode.mean_search_time = number("mean_search_time_s");
  episode.max_search_time = number("max_search_time_s");
  episode.mean_trials = number("mean_trials");
  episode.bound_violations = count("lower_bound_violations");
  episode.decisions = countIfThere("decisions");
  episode.stale_paths = countIfThere("stale_paths");
  return episode;
}

void requireRows(const CsvTable& table) {
  if (table.rowCount() > 0) return;
  throw std::runtime_error(table.path() + ":2: expected a row, there is none");
}

}  // namespace

ResultsFile readResults(const std::string& path) {
  const CsvTable table(path);
  ResultsFile results{path, {}, std::nullopt};
  std::set<std::string> seen;
  for (size_t row = 0; row < table.rowCount(); ++row) {
    results.rows.push_back(rowOf(table, row));
    const std::string cells = trialCells(results.rows.back().trial);
    if (!seen.insert(cells).second) {
      table.fail(row, fmt::format("the episode '{}' is there twice", cells));
    }
  }
  requireRows(table);
  const std::string settings = settingsPath(path);
  if (std::filesystem::exists(settings)) results.settings = readSettings(settings);
  return results;
}

bool TripKey::operator<(const TripKey& other) const {
  return std::tie(world, pedestrians, seed, max_speed) <
         std::tie(other.world, other.pedestrians, other.seed, other.max_speed);
}

BoundsOfTrips readBounds(const std::vector<std::string>& paths) {
  BoundsOfTrips bounds;
  for (const std::string& path : paths) {
    const CsvTable table(path);
    requireRows(table);
    for (size_t row = 0; row < table.rowCount(); ++row) {
      const TripKey key{table.text(row, table.column("world")),
                        static_cast<int>(table.count(row, table.column("pedestrians"))),
                        static_cast<std::uint64_t>(table.count(row, table.column("seed"))),
                        std::lround(1000.0 * table.number(row, table.column("max_speed_mps")))};
      const TripBounds trip{table.numberOrNothing(row, table.column("bound_s")),
                            table.number(row, table.column("free_drive_s"))};
      if (trip.plan && *trip.plan <= 0.0) table.fail(row, "bound_s: expected a number above 0");
      if (trip.free_drive <= 0.0) table.fail(row, "free_drive_s: expected a number above 0");
      if (!bounds.emplace(key, trip).second) table.fail(row, "the bound is there twice");
    }
  }
  return bounds;
}

}  // namespace pomdp_crowd_nav
