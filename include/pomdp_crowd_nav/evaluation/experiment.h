// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "pomdp_crowd_nav/evaluation/episode.h"

namespace pomdp_crowd_nav {

// One episode of an experiment: everything that tells it from the others.
struct Trial {
  std::string world;
  int pedestrians = 100;
  std::string planner;
  std::uint64_t seed = 1;
};

// Which episodes to run: all combinations, seeds first_seed .. first_seed + runs - 1 innermost, so
// that every planner meets the same people.
struct ExperimentPlan {
  std::vector<std::string> worlds;
  std::vector<int> pedestrians;
  std::vector<std::string> planners;
  int runs = 1;
  std::uint64_t first_seed = 1;

  std::vector<Trial> trials() const;
};

// Runs one trial to its end; called from several threads at once.
using TrialRunner = std::function<EpisodeResult(const Trial&)>;
// Receives every result as soon as it is there, with the index of its trial; never called from two
// threads at once.
using ResultSink = std::function<void(size_t, const EpisodeResult&)>;

// Runs the trials on `jobs` threads, in order. An exception of a runner or the sink stops the
// experiment and is thrown on; results that came before it have been delivered. A sink that has
// thrown receives nothing more.
void runTrials(const std::vector<Trial>& trials, int jobs, const TrialRunner& runner,
               const ResultSink& sink);

// The columns of a results file, and a row of it (doc/tools.md).
std::string csvHeader();
std::string csvRow(const Trial& trial, const EpisodeResult& result);

// The columns of a trails file, and its lines for one episode: where the robot was at the start,
// after each step and at the end.
std::string trailHeader();
std::string trailRows(const Trial& trial, const Point& start, double step,
                      const EpisodeResult& result);

// The cells that tell a trial from the others and begin each of its rows, with their last comma.
std::string trialCells(const Trial& trial);

}  // namespace pomdp_crowd_nav
