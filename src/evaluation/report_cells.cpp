// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <limits>

#include "pomdp_crowd_nav/evaluation/report.h"

namespace pomdp_crowd_nav {
namespace {

bool countsForMeans(const EpisodeRow& row) { return row.reached && row.unsafe_ticks == 0; }

}  // namespace

std::vector<Cell> cellsOf(const std::vector<EpisodeRow>& rows) {
  std::vector<Cell> cells;
  for (const EpisodeRow& row : rows) {
    const Trial& trial = row.trial;
    auto cell = std::find_if(cells.begin(), cells.end(), [&](const Cell& other) {
      return other.world == trial.world && other.pedestrians == trial.pedestrians &&
             other.planner == trial.planner;
    });
    if (cell == cells.end()) {
      cells.push_back({trial.world, trial.pedestrians, trial.planner, {}});
      cell = std::prev(cells.end());
    }
    cell->episodes.push_back(&row);
  }
  return cells;
}

CellSummary summarize(const Cell& cell) {
  CellSummary summary;
  summary.min_distance = std::numeric_limits<double>::infinity();
  std::vector<double> times, brakes;
  std::int64_t decisions = 0, stale = 0;
  bool counts_paths = true;
  for (const EpisodeRow* row : cell.episodes) {
    ++summary.episodes;
    if (row->reached) ++summary.arrived;
    if (countsForMeans(*row)) {
      times.push_back(row->travel_time);
      brakes.push_back(static_cast<double>(row->sudden_brakes));
    }
    if (row->unsafe_steps > 0) ++summary.unsafe_episodes;
    summary.unsafe_steps += row->unsafe_steps;
    if (row->unsafe_ticks > 0) ++summary.risky_episodes;
    summary.unsafe_ticks += row->unsafe_ticks;
    if (row->min_moving_distance) {
      summary.min_distance = std::min(summary.min_distance, *row->min_moving_distance);
    }
    summary.mean_search_time += row->mean_search_time;
    summary.max_search_time = std::max(summary.max_search_time, row->max_search_time);
    summary.mean_trials += row->mean_trials;
    summary.bound_violations += row->bound_violations;
    counts_paths = counts_paths && row->decisions && row->stale_paths;
    decisions += row->decisions.value_or(0);
    stale += row->stale_paths.value_or(0);
  }
  summary.mean_search_time /= summary.episodes;
  summary.mean_trials /= summary.episodes;
  summary.travel_time = summarize(times);
  summary.sudden_brakes = summarize(brakes);
  summary.stale_share = counts_paths && decisions > 0
                            ? static_cast<double>(stale) / static_cast<double>(decisions)
                            : std::numeric_limits<double>::quiet_NaN();
  return summary;
}

Pairs comparePairs(const Cell& cell, const Cell& baseline) {
  std::map<std::uint64_t, double> times;  // of the baseline, by seed
  for (const EpisodeRow* row : baseline.episodes) {
    if (countsForMeans(*row)) times[row->trial.seed] = row->travel_time;
  }
  Pairs pairs;
  std::vector<double> differences, reductions;
  for (const EpisodeRow* row : cell.episodes) {
    const auto other = times.find(row->trial.seed);
    if (other == times.end() || !countsForMeans(*row)) continue;
    ++pairs.count;
    if (row->travel_time < other->second) ++pairs.won;
    differences.push_back(row->travel_time - other->second);
    reductions.push_back(1.0 - row->travel_time / other->second);
  }
  pairs.difference = summarize(differences);
  pairs.reduction = summarize(reductions);
  return pairs;
}

BoundDistances compareWithBounds(const Cell& cell, const BoundsOfTrips& bounds, long max_speed) {
  struct Differences {
    std::vector<double> differences, ratios;
    void add(double time, double bound) {
      differences.push_back(time - bound);
      ratios.push_back(time / bound);
    }
    BoundDistance summary() const { return {summarize(differences), summarize(ratios)}; }
  };
  Differences plan, free_drive;
  for (const EpisodeRow* row : cell.episodes) {
    const Trial& trial = row->trial;
    const auto trip = bounds.find({trial.world, trial.pedestrians, trial.seed, max_speed});
    if (trip == bounds.end() || !countsForMeans(*row)) continue;
    if (trip->second.plan) plan.add(row->travel_time, *trip->second.plan);
    free_drive.add(row->travel_time, trip->second.free_drive);
  }
  return {plan.summary(), free_drive.summary()};
}

}  // namespace pomdp_crowd_nav
