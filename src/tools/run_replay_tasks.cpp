// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <stdexcept>

#include "config_files.h"
#include "option_checks.h"
#include "pomdp_crowd_nav/evaluation/replay_task.h"
#include "pomdp_crowd_nav/params/yaml_param_reader.h"
#include "progress.h"
#include "run_tool.h"

using namespace pomdp_crowd_nav;

namespace {

struct Options {
  std::string config = findConfigFolder();
  std::string world = "ucy_zara01";
  std::string profile = "street";
  std::string tracks;
  std::string tasks;
  long max_trials = 200;
  std::uint64_t seed = 1;
};

constexpr double kContactDistance = 0.6;  // [m], between centres

EpisodeParams loadEpisodeParams(const Options& options) {
  auto reader = YamlParamReader::fromFile(configFile(options.config, "profiles", options.profile));
  EpisodeParams params;
  params.navigation = loadNavigationParams(reader);
  params.simulator = loadSimulatorParams(reader, params.navigation.planning.model.vehicle);
  reader.requireAllUsed();
  params.max_trials = options.max_trials;
  params.seed = options.seed;
  params.time_limit = 120.0;
  return params;
}

void requireDrivableTasks(const std::vector<ReplayTask>& tasks, const World& world,
                          const EpisodeParams& params, const std::string& file) {
  for (const ReplayTask& task : tasks) {
    try {
      requireDrivable(worldOf(task, world), params);
    } catch (const std::exception& error) {
      throw std::runtime_error(fmt::format("{}: person {}: {}", file, task.person, error.what()));
    }
  }
}

void run(const Options& options) {
  const EpisodeParams params = loadEpisodeParams(options);
  World world = loadWorld(configFile(options.config, "worlds", options.world));
  world.tracks_file = options.tracks;
  const std::vector<ReplayTask> tasks = loadReplayTasks(options.tasks);
  requireDrivableTasks(tasks, world, params, options.tasks);
  std::vector<EpisodeResult> results;
  const bool shows_rows = isatty(STDOUT_FILENO) == 1;
  Progress progress(0, tasks.size(), "trips");
  fmt::print(
      "person,end,travel_time_s,person_time_s,min_moving_distance_m,person_min_distance_m\n");
  for (const ReplayTask& task : tasks) {
    results.push_back(runEpisode(worldOf(task, world), params));
    const EpisodeMetrics& metrics = results.back().metrics;
    fmt::print("{},{},{:.1f},{:.1f},{:.2f},{:.2f}\n", task.person, describe(results.back().end),
               metrics.travel_time, task.person_time, metrics.min_moving_distance,
               task.person_min_distance);
    std::fflush(stdout);
    if (!shows_rows) progress.show(results.size());
  }
  const ReplaySummary summary = summarize(tasks, results, kContactDistance);
  fmt::print("tasks={} arrived={} mean_time_ratio={:.3f} robot_contacts={} person_contacts={}\n",
             summary.tasks, summary.arrived, summary.mean_time_ratio, summary.robot_contacts,
             summary.person_contacts);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{
      "Lets the robot take the place of recorded people, one trip each, and compares it with "
      "them."};
  app.footer(std::string(R"(
Example (doc/recorded_people.md says where recordings come from):
  run_replay_tasks --world ucy_zara01 --tracks ucy_zara01.csv --tasks ucy_zara01.json
)") + kExitStatus);
  Options options;
  app.add_option("--config", options.config, "Folder of worlds and profiles")
      ->capture_default_str();
  app.add_option("--world", options.world, "The recording's: a name in config/worlds, or a file")
      ->capture_default_str();
  app.add_option("--profile", options.profile, "A name in config/profiles, or a file")
      ->capture_default_str();
  app.add_option("--tracks", options.tracks, "CSV of the recorded people")->required();
  app.add_option("--tasks", options.tasks, "JSON with replace_person_tasks")->required();
  app.add_option("--max-trials", options.max_trials, "Search trials for each decision")
      ->check(wholeNumber(1, 1000000000))
      ->capture_default_str();
  app.add_option("--seed", options.seed, "Seed of the sampled futures")
      ->check(wholeNumber(0, 4294967295))
      ->capture_default_str();
  return runTool("run_replay_tasks", app, argc, argv, [&] {
    run(options);
    return 0;
  });
}
