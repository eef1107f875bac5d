// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <map>

#include "config_files.h"
#include "option_checks.h"
#include "pomdp_crowd_nav/evaluation/experiment.h"
#include "pomdp_crowd_nav/params/yaml_param_reader.h"
#include "pomdp_crowd_nav/planner/planner_factory.h"

using namespace pomdp_crowd_nav;

namespace {

struct Options {
  ExperimentPlan plan{{"scenario_1"}, {100}, {"2d_fmm"}, 1, 1};
  std::string config = findConfigFolder();
  std::string profile;  // empty: as simulation.launch chooses it
  std::string output;
  std::string tracks;
  int jobs = 1;
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
  app.add_option("--jobs", options.jobs, "Episodes run at once")
      ->check(wholeNumber(1, 256))
      ->capture_default_str();
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
  app.add_option("--output", options.output, "CSV to write; standard output without it");
}

// A world with the vehicle and the tuning for it.
struct Setup {
  World world;
  EpisodeParams params;
};

EpisodeParams loadEpisodeParams(const Options& options, const std::string& profile) {
  auto reader = YamlParamReader::fromFile(configFile(options.config, "profiles", profile));
  EpisodeParams params;
  params.navigation = loadNavigationParams(reader);
  params.simulator = loadSimulatorParams(reader, params.navigation.planning.model.vehicle);
  reader.requireAllUsed();
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

// Everything that can be wrong shows here, before the first result is due.
std::map<std::string, Setup> loadSetups(const Options& options) {
  std::map<std::string, Setup> setups;
  for (const std::string& name : options.plan.worlds) {
    const std::string profile = options.profile.empty() ? profileFor(name) : options.profile;
    const EpisodeParams params = loadEpisodeParams(options, profile);
    World world = loadWorld(configFile(options.config, "worlds", name));
    if (!options.tracks.empty()) world.tracks_file = options.tracks;
    for (const std::string& planner : options.plan.planners) {
      requireDrivable(world, paramsOf({name, options.plan.pedestrians[0], planner}, params));
    }
    if (options.profile.empty() && profile != "paper") {
      fmt::print(stderr, "{}: with the profile {}\n", name, profile);
    }
    setups[name] = {world, params};
  }
  return setups;
}

// Results that are there already are never overwritten.
std::FILE* openOutput(const std::string& path) {
  if (path.empty()) return stdout;
  std::FILE* file = std::fopen(path.c_str(), "wx");
  if (file != nullptr) return file;
  throw std::runtime_error(fmt::format("--output: cannot write '{}': {}", path,
                                       errno == EEXIST ? "it exists" : std::strerror(errno)));
}

// Progress and time left, on standard error.
class Progress {
 public:
  explicit Progress(size_t total) : total_(total) {}

  void show(size_t done) const {
    const double elapsed =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    const double left = elapsed / static_cast<double>(done) * static_cast<double>(total_ - done);
    fmt::print(stderr, "\r{}/{} episodes, {:.0f} s left   {}", done, total_, left,
               done == total_ ? "\n" : "");
    std::fflush(stderr);
  }

 private:
  size_t total_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

void run(const Options& options) {
  const std::map<std::string, Setup> setups = loadSetups(options);
  const std::vector<Trial> trials = options.plan.trials();
  std::FILE* out = openOutput(options.output);
  fmt::print(out, "{}\n", csvHeader());
  const bool shows_rows = out == stdout && isatty(STDOUT_FILENO) == 1;
  const Progress progress(trials.size());
  size_t done = 0;
  runTrials(
      trials, options.jobs,
      [&](const Trial& trial) {
        const Setup& setup = setups.at(trial.world);
        return runEpisode(setup.world, paramsOf(trial, setup.params));
      },
      [&](const Trial& trial, const EpisodeResult& result) {
        fmt::print(out, "{}\n", csvRow(trial, result));
        std::fflush(out);
        ++done;
        if (!shows_rows) progress.show(done);
      });
  if (out != stdout) std::fclose(out);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Drives episodes without ROS and writes one CSV row for each."};
  Options options;
  addOptions(app, options);
  try {
    app.parse(argc, argv);
    run(options);
  } catch (const CLI::CallForHelp& help) {
    return app.exit(help);
  } catch (const std::exception& error) {
    fmt::print(stderr, "run_experiments: {}\n", error.what());
    return 2;
  }
  return 0;
}
