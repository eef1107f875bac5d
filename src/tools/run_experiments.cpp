// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <optional>
#include <thread>

#include "experiment_setups.h"
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
  ExperimentPlan plan{{"scenario_1"}, {100}, {}, 1, 1};
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
  app.add_option("--planners", options.plan.planners,
                 "Planners to compare; without it the one of the profile")
      ->check(oneOf(plannerNames()));
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

// Another result than that of the same episode run to its end does not come out of it.
EpisodeResult runUnlessInterrupted(const Setup& setup, const Trial& trial) {
  Interruption::throwIfReceived();
  return runEpisode(setup.world, paramsOf(trial, setup.params),
                    [](const EpisodeMoment&) { Interruption::throwIfReceived(); });
}

class Experiment {
 public:
  explicit Experiment(const Options& options)
      : options_(options),
        settings_(settingsOf(options)),
        setups_({options.config, options.profile, options.replaced}, settings_) {
    // Everything that can be wrong shows here, before the first result is due.
    setups_.requireAllDrivable(settings_.plan);
    trials_ = settings_.plan.trials();
    log_.emplace(ExperimentLog::Files{options.output, options.trails, options.resume}, trials_,
                 settings_);
    for (size_t i = 0; i < trials_.size(); ++i) {
      if (log_->has(i)) continue;
      indices_.push_back(i);
      missing_.push_back(trials_[i]);
    }
  }

  void run() {
    sayWhatIsThere();
    Progress progress(log_->count(), trials_.size(), "episodes");
    Interruption::listen();
    try {
      runTrials(
          missing_, options_.jobs,
          [&](const Trial& trial) { return runUnlessInterrupted(setups_.of(trial.world), trial); },
          [&](size_t i, const EpisodeResult& result) {
            add(i, result);
            if (!shows_rows_) progress.show(log_->count());
          });
    } catch (const Interruption::Signal&) {
      progress.endLine();
      sayHowToGoOn();
      throw;
    } catch (...) {
      progress.endLine();
      throw;
    }
  }

 private:
  static ExperimentSettings settingsOf(const Options& options) {
    ExperimentSettings settings;
    settings.version = PROGRAM_VERSION;
    settings.plan = options.plan;
    settings.max_trials = options.search_time > 0.0 ? 0 : options.max_trials;
    settings.search_time = options.search_time;
    settings.tracks = options.tracks;
    settings.replaced = options.replaced;
    return settings;
  }

  void add(size_t i, const EpisodeResult& result) {
    const Setup& setup = setups_.of(missing_[i].world);
    log_->add(indices_[i], csvRow(missing_[i], result),
              trailRows(missing_[i], setup.world.start.position,
                        setup.params.navigation.planning.model.step, result));
  }

  void sayWhatIsThere() const {
    for (const std::string& world : settings_.plan.worlds) {
      const std::string& profile = settings_.worlds.at(world).profile;
      if (!options_.profile.empty() || profile == "paper") continue;
      fmt::print(stderr, "{}: with the profile {}\n", world, profile);
    }
    if (log_->hasDroppedLine()) {
      fmt::print(stderr, "{}: dropped an incomplete line at its end\n", options_.output);
    }
    if (log_->count() == 0) return;
    fmt::print(stderr, "{}: {} of {} episodes are there\n", options_.output, log_->count(),
               trials_.size());
  }

  void sayHowToGoOn() const {
    fmt::print(stderr, "run_experiments: interrupted after {} of {} episodes{}\n", log_->count(),
               trials_.size(),
               options_.output.empty()
                   ? ""
                   : "; the same command with --resume goes on in " + options_.output);
  }

  const Options& options_;
  ExperimentSettings settings_;
  Setups setups_;
  std::vector<Trial> trials_;
  std::optional<ExperimentLog> log_;
  std::vector<size_t> indices_;  // of the trials that are missing
  std::vector<Trial> missing_;
  bool shows_rows_ = options_.output.empty() && isatty(STDOUT_FILENO) == 1;
};

void run(const Options& options) {
  requireWorlds(options.plan.worlds);
  requireDifferent("--pedestrians", options.plan.pedestrians);
  requireDifferent("--planners", options.plan.planners);
  Experiment(options).run();
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Drives episodes without ROS and writes one CSV row for each."};
  app.footer(std::string(R"(
Examples:
  run_experiments --pedestrians 0 --max-trials 1      a first row within a second
  run_experiments --worlds scenario_1 scenario_2 --pedestrians 100 400 \
    --planners 1d_astar 2d_fmm --runs 20 --output results.csv
  ... the same with --resume                          goes on where it was interrupted
  run_experiments --worlds yard.yaml --profile my_robot.yaml --set search/scenarios=50
  report_experiments results.csv                      sums them up
)") + kExitStatusOfLongRuns);
  Options options;
  addOptions(app, options);
  return runTool("run_experiments", app, argc, argv, [&] {
    run(options);
    return 0;
  });
}
