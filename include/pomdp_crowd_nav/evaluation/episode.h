// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "pomdp_crowd_nav/evaluation/metrics.h"
#include "pomdp_crowd_nav/params/load_params.h"
#include "pomdp_crowd_nav/planner/navigation_tables.h"
#include "pomdp_crowd_nav/planner/planner.h"
#include "pomdp_crowd_nav/sim/simulator.h"

namespace pomdp_crowd_nav {

// Robot, world outside it, and when a search and an episode end.
struct EpisodeParams {
  NavigationParams navigation;
  Simulator::Params simulator;
  std::uint64_t seed = 1;     // of the crowd and the sampled futures
  long max_trials = 200;      // per decision; 0: none, the clock decides (search_time)
  double time_limit = 300.0;  // [s]
  // Of all episodes in this world with these navigation parameters; none: each makes its own.
  std::shared_ptr<SharedTables> tables;
};

enum class EpisodeEnd { kGoalReached, kTimeLimit, kLeftField, kHitObstacle };

const char* describe(EpisodeEnd end);

// How an episode went.
struct EpisodeResult {
  EpisodeEnd end = EpisodeEnd::kTimeLimit;
  EpisodeMetrics metrics;
  std::vector<Point> trail;       // [m], the robot at every tick
  double mean_search_time = 0.0;  // [s]
  double max_search_time = 0.0;   // [s]
  double mean_trials = 0.0;
  long bound_violations = 0;
  int stale_paths = 0;  // decisions without a fresh path

  bool reachedGoal() const { return end == EpisodeEnd::kGoalReached; }
};

// What an observer of an episode sees after each decision.
struct EpisodeMoment {
  double time = 0.0;
  const Decision& decision;
  const Simulator& simulator;
  const Planner& planner;
  const CrowdBelief& crowd;  // as of the newest tracks
};

// One trip in lockstep: tracker, planner, override and simulator take turns, and simulated time
// stands still while the planner thinks. Same parameters, world and trial limit: same episode.
//
// For the first step the robot waits and watches people, which counts as travel time (facts
// sheet, section 1).
EpisodeResult runEpisode(const World& world, const EpisodeParams& params,
                         const std::function<void(const EpisodeMoment&)>& observer = nullptr);

// Throws with one line that names the world where `runEpisode` could not begin, the goal is no
// place for the robot, or there is no way to it.
void requireDrivable(const World& world, const EpisodeParams& params);

}  // namespace pomdp_crowd_nav
