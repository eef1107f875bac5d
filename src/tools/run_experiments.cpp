// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <map>
#include <memory>
#include <thread>

#include "config_files.h"
#include "episode_params.h"
#include "interruption.h"
#include "option_checks.h"
#include "pomdp_crowd_nav/evaluation/experiment.h"
#include "pomdp_crowd_nav/evaluation/experiment_log.h"
#include "pomdp_crowd_nav/planner/planner_factory.h"
#include "progress.h"
#include "run_tool.h"

using namespace pomdp_crowd_nav;

namespace {

struct Options {
  ExperimentPlan plan{{"scenario_1"}, {100}, {"2d_fmm"}, 1, 1};
  std::string config = findConfigFolder();
  std::string profile;  // empty: as simulation.launch chooses it
  std::string output;
  std::string trails;
  std::string tracks;
  std::vector<std::string> replaced;  // KEY=VALUE
  bool resume = false;
  int jobs = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  double search_time = 0.0;
  long max_trials = 200;
};

void addOptions(CLI::App& app, Options& options) {
  auto* worlds =
      app.add_option("--worlds", options.plan.worlds, "Names in config/worlds, or yaml files")
          ->capture_default_str();
  app.add_option("--pedestrians", options.plan.pedestrians, "Sizes of the crowd")
      ->check(wholeNumber(0, 10000))
      ->capture_default_str();
  app.add_option("--planners", options.plan.planners, "Planners to compare")
      ->check(CLI::IsMember(plannerNames()))
      ->capture_default_str();
  app.add_option("--runs", options.plan.runs, "Episodes of each combination")
      ->check(wholeNumber(1, 1000000))
      ->capture_default_str();
  app.add_option("--seed", options.plan.first_seed, "Seed of the first run; the others follow")
      ->check(wholeNumber(0, 4294967295))
      ->capture_default_str();
  app.add_option("--jobs", options.jobs, "Episodes run at once; without it one on each core")
      ->check(wholeNumber(1, 256));
  auto* time = app.add_option("--search-time", options.search_time,
                              "Wall clock for each decision [s] (not reproducible to the bit)")
                   ->check(positiveNumber());
  app.add_option("--max-trials", options.max_trials, "Search trials for each decision")
      ->check(wholeNumber(1, 1000000000))
      ->capture_default_str()
      ->excludes(time);
  app.add_option("--profile", options.profile,
                 "Name in config/profiles, or a yaml file; without it paper for the worlds "
                 "scenario_*, street for the others");
  app.add_option("--config", options.config, "Folder of worlds and profiles")
      ->capture_default_str();
  app.add_option("--tracks", options.tracks, "CSV of recorded people, who replace the worlds' own")
      ->needs(worlds);
  app.add_option("--set", options.replaced,
                 "KEY=VALUE of the profile, instead of what it says, such as "
                 "search/scenarios=50")
      ->expected(1, 1000);
  auto* output =
      app.add_option("--output", options.output, "CSV to write; standard output without it");
  app.add_option("--trails", options.trails, "CSV to write: where the robot was at each step")
      ->needs(output);
  app.add_flag("--resume", options.resume, "Goes on with --output where an earlier run ended")
      ->needs(output);
}

// A world with the vehicle and the tuning for it.
struct Setup {
  World world;
  EpisodeParams params;
};

EpisodeParams withLimits(const Options& options, EpisodeParams params) {
  params.max_trials = options.max_trials;
  if (options.search_time > 0.0) {
    params.max_trials = 0;
    params.navigation.search_time = options.search_time;
  }
  return params;
}

EpisodeParams paramsOf(const Trial& trial, EpisodeParams params) {
  params.navigation.planner = trial.planner;
  params.simulator.pedestrians = trial.pedestrians;
  params.seed = trial.seed;
  return params;
}

ExperimentSettings::WorldSettings settingsOf(const std::string& profile, const Setup& setup,
                                             const YamlParamReader& reader,
                                             const std::string& world_file) {
  const VehicleKind kind = setup.params.navigation.planning.model.vehicle.kind;
  return {profile, kind == VehicleKind::kCar ? "car" : "holonomic", reader.texts(),
          YamlParamReader::fromFile(world_file).texts()};
}

// Everything that can be wrong shows here, before the first result is due.
std::map<std::string, Setup> loadSetups(const Options& options, ExperimentSettings& settings) {
  std::map<std::string, Setup> setups;
  for (const std::string& name : options.plan.worlds) {
    const std::string profile = options.profile.empty() ? profileFor(name) : options.profile;
    YamlParamReader reader = openProfile(options.config, profile, options.replaced);
    const std::string world_file = configFile(options.config, "worlds", name);
    Setup setup{loadWorld(world_file), withLimits(options, loadEpisodeParams(reader))};
    if (!options.tracks.empty()) setup.world.tracks_file = options.tracks;
    setup.params.tables = std::make_shared<SharedTables>();
    for (const std::string& planner : options.plan.planners) {
      requireDrivable(setup.world,
                      paramsOf({name, options.plan.pedestrians[0], planner}, setup.params));
    }
    if (options.profile.empty() && profile != "paper") {
      fmt::print(stderr, "{}: with the profile {}\n", name, profile);
    }
    settings.worlds[name] = settingsOf(profile, setup, reader, world_file);
    setups.emplace(name, std::move(setup));
  }
  return setups;
}

template <typename T>
void requireDifferent(const char* option, std::vector<T> values) {
  std::sort(values.begin(), values.end());
  const auto twice = std::adjacent_find(values.begin(), values.end());
  if (twice == values.end()) return;
  throw std::runtime_error(fmt::format("{}: {} is named twice", option, *twice));
}

void requireDistinctTrials(const ExperimentPlan& plan) {
  requireDifferent("--worlds", plan.worlds);
  requireDifferent("--pedestrians", plan.pedestrians);
  requireDifferent("--planners", plan.planners);
  for (const std::string& world : plan.worlds) {
    if (world.find_first_of(",\"\n\r") == std::string::npos) continue;
    throw std::runtime_error(
        fmt::format("--worlds: '{}' has a character that a CSV file cannot hold", world));
  }
}

// Another result than that of the same episode run to its end does not come out of it.
EpisodeResult runUnlessInterrupted(const Setup& setup, const Trial& trial) {
  Interruption::throwIfReceived();
  return runEpisode(setup.world, paramsOf(trial, setup.params),
                    [](const EpisodeMoment&) { Interruption::throwIfReceived(); });
}

void announceInterruption(const Options& options, const ExperimentLog& log, size_t total) {
  fmt::print(stderr, "run_experiments: interrupted after {} of {} episodes{}\n", log.count(), total,
             options.output.empty()
                 ? ""
                 : "; the same command with --resume goes on in " + options.output);
}

void run(const Options& options) {
  requireDistinctTrials(options.plan);
  ExperimentSettings settings{
      options.plan,        options.search_time > 0.0 ? 0 : options.max_trials,
      options.search_time, options.tracks,
      options.replaced,    {}};
  const std::map<std::string, Setup> setups = loadSetups(options, settings);
  const std::vector<Trial> trials = options.plan.trials();
  ExperimentLog log({options.output, options.trails, options.resume}, trials, settings);
  std::vector<size_t> indices;  // of the trials to run
  std::vector<Trial> missing;
  for (size_t i = 0; i < trials.size(); ++i) {
    if (log.has(i)) continue;
    indices.push_back(i);
    missing.push_back(trials[i]);
  }
  if (log.hasDroppedLine()) {
    fmt::print(stderr, "{}: dropped an incomplete line at its end\n", options.output);
  }
  if (log.count() > 0) {
    fmt::print(stderr, "{}: {} of {} episodes are there\n", options.output, log.count(),
               trials.size());
  }
  const bool shows_rows = options.output.empty() && isatty(STDOUT_FILENO) == 1;
  Progress progress(log.count(), trials.size(), "episodes");
  Interruption::listen();
  try {
    runTrials(
        missing, options.jobs,
        [&](const Trial& trial) { return runUnlessInterrupted(setups.at(trial.world), trial); },
        [&](size_t i, const EpisodeResult& result) {
          const Setup& setup = setups.at(missing[i].world);
          log.add(indices[i], csvRow(missing[i], result),
                  trailRows(missing[i], setup.world.start.position,
                            setup.params.navigation.planning.model.step, result));
          if (!shows_rows) progress.show(log.count());
        });
  } catch (const Interruption::Signal&) {
    progress.endLine();
    announceInterruption(options, log, trials.size());
    throw;
  } catch (...) {
    progress.endLine();
    throw;
  }
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Drives episodes without ROS and writes one CSV row for each."};
  Options options;
  addOptions(app, options);
  return runTool("run_experiments", app, argc, argv, [&] {
    run(options);
    return 0;
  });
}
