// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/evaluation/experiment.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "pomdp_crowd_nav/evaluation/parallel_jobs.h"

namespace pomdp_crowd_nav {
namespace {

// A number for a CSV cell; empty where nothing was measured.
std::string cell(double value) {
  return std::isfinite(value) ? fmt::format("{:.3f}", value) : std::string();
}

}  // namespace

std::vector<Trial> ExperimentPlan::trials() const {
  std::vector<Trial> all;
  for (const std::string& world : worlds) {
    for (const int count : pedestrians) {
      for (const std::string& planner : planners) {
        for (int run = 0; run < runs; ++run) {
          all.push_back({world, count, planner, first_seed + static_cast<std::uint64_t>(run)});
        }
      }
    }
  }
  return all;
}

void runTrials(const std::vector<Trial>& trials, int jobs, const TrialRunner& runner,
               const ResultSink& sink) {
  runJobs(trials.size(), jobs, [&](size_t index) -> Delivery {
    return [&sink, index, result = runner(trials[index])] { sink(index, result); };
  });
}

std::string csvHeader() {
  return "world,pedestrians,planner,seed,reached,travel_time_s,sudden_brakes,"
         "min_moving_distance_m,unsafe_steps_1m,unsafe_ticks_0_5m,path_length_m,"
         "mean_search_time_s,max_search_time_s,mean_trials,lower_bound_violations,decisions,stale_"
         "paths";
}

std::string csvRow(const Trial& trial, const EpisodeResult& result) {
  const EpisodeMetrics& m = result.metrics;
  return fmt::format("{}{},{},{},{},{},{},{},{:.6f},{:.6f},{:.1f},{},{},{}", trialCells(trial),
                     result.reachedGoal() ? 1 : 0, cell(m.travel_time), m.sudden_brakes,
                     cell(m.min_moving_distance), m.unsafe_steps, m.unsafe_ticks,
                     cell(m.path_length), result.mean_search_time, result.max_search_time,
                     result.mean_trials, result.bound_violations, m.decisions, result.stale_paths);
}

std::string trailHeader() { return "world,pedestrians,planner,seed,time_s,x_m,y_m"; }

std::string trailRows(const Trial& trial, const Point& start, double step,
                      const EpisodeResult& result) {
  const std::string cells = trialCells(trial);
  std::string rows;
  const auto add = [&](double time, const Point& place) {
    rows += fmt::format("{}{:.2f},{:.2f},{:.2f}\n", cells, time, place.x(), place.y());
  };
  add(0.0, start);
  const size_t ticks = std::max<long>(1, std::lround(step / Crowd::kTick));
  for (size_t i = ticks; i <= result.trail.size(); i += ticks) {
    add(static_cast<double>(i) * Crowd::kTick, result.trail[i - 1]);
  }
  return rows;
}

std::string trialCells(const Trial& trial) {
  return fmt::format("{},{},{},{},", trial.world, trial.pedestrians, trial.planner, trial.seed);
}

}  // namespace pomdp_crowd_nav
