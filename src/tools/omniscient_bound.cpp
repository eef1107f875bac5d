// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/evaluation/omniscient_bound.h"

#include <deque>
#include <optional>
#include <thread>

#include "config_files.h"
#include "episode_params.h"
#include "interruption.h"
#include "option_checks.h"
#include "pomdp_crowd_nav/evaluation/durable_file.h"
#include "pomdp_crowd_nav/evaluation/parallel_jobs.h"
#include "pomdp_crowd_nav/pomdp/upper_bound.h"
#include "pomdp_crowd_nav/prior/clearance_grid.h"
#include "progress.h"
#include "run_tool.h"

using namespace pomdp_crowd_nav;

namespace {

struct Options {
  std::vector<std::string> worlds{"scenario_1"};
  std::vector<int> pedestrians{100};
  int runs = 1;
  std::uint64_t seed = 1;
  std::string config = findConfigFolder();
  std::string profile;
  std::string tracks;
  std::string output;
  int jobs = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
};

void addOptions(CLI::App& app, Options& options) {
  auto* worlds = app.add_option("--worlds", options.worlds, "Names in config/worlds, or yaml files")
                     ->capture_default_str();
  app.add_option("--pedestrians", options.pedestrians, "Sizes of the crowd")
      ->check(wholeNumber(0, 10000))
      ->capture_default_str();
  app.add_option("--runs", options.runs, "Crowds of each combination")
      ->check(wholeNumber(1, 1000000))
      ->capture_default_str();
  app.add_option("--seed", options.seed, "Seed of the first crowd; the others follow")
      ->check(wholeNumber(0, 4294967295))
      ->capture_default_str();
  app.add_option("--jobs", options.jobs, "Crowds at once; without it one on each core")
      ->check(wholeNumber(1, 256));
  app.add_option("--profile", options.profile,
                 "Name in config/profiles, or a yaml file; without it paper for the worlds "
                 "scenario_*, street for the others");
  app.add_option("--config", options.config, "Folder of worlds and profiles")
      ->capture_default_str();
  app.add_option("--tracks", options.tracks, "CSV of recorded people, who replace the worlds' own")
      ->needs(worlds);
  app.add_option("--output", options.output, "CSV to write; standard output without it");
}

// What the first speeding up costs against a base that is at full speed at once [s].
double speedUpLoss(const ModelParams& model) {
  const double top = model.vehicle.max_speed;
  double loss = 0.0;
  for (double speed = model.speedStep(); speed < top - 1e-9; speed += model.speedStep()) {
    loss += (1.0 - speed / top) * model.step;
  }
  // Between two speeds a real base is at their mean.
  if (!model.vehicle.instant_velocity) loss += 0.5 * model.step;
  return loss;
}

OmniscientBound::Params boundParams(const ModelParams& model) {
  OmniscientBound::Params params;
  params.max_speed = model.vehicle.max_speed;
  params.start_delay = model.step + speedUpLoss(model);
  params.obstacle_clearance = model.obstacleClearance();
  params.goal_tolerance = model.goal_tolerance;
  return params;
}

// A certified lower limit of the drive without people [s].
double freeDriveTime(const World& world, const NavigationParams& navigation,
                     const OmniscientBound& bound, double start_delay) {
  const ModelParams& model = navigation.planning.model;
  const ClearanceGrid map(world.map(), navigation.planning.prior.resolution);
  const auto shortest_way = makeShortestWay(model, map, world.goal);
  if (!shortest_way) return bound.beelineTime();
  const Point& start = world.start.position;
  const double way =
      shortest_way->lengthFrom(static_cast<float>(start.x()), static_cast<float>(start.y()));
  return std::max(bound.beelineTime(), start_delay + way / model.vehicle.max_speed);
}

// A world with its vehicle, and what can be said of it before anybody is there.
class BoundSetup {
 public:
  BoundSetup(const Options& options, const std::string& name) : name_(name) {
    const std::string profile = options.profile.empty() ? profileFor(name) : options.profile;
    YamlParamReader reader = openProfile(options.config, profile, {});
    const EpisodeParams episode = loadEpisodeParams(reader);
    simulator_ = episode.simulator;
    world_ = loadWorld(configFile(options.config, "worlds", name));
    if (!options.tracks.empty()) world_.tracks_file = options.tracks;
    const OmniscientBound::Params params = boundParams(episode.navigation.planning.model);
    max_speed_ = params.max_speed;
    bound_.emplace(world_, params);
    if (!std::isfinite(bound_->emptyDriveTime())) {
      throw std::runtime_error(fmt::format("{}: no way to the goal", world_.name));
    }
    free_drive_ = freeDriveTime(world_, episode.navigation, *bound_, params.start_delay);
  }

  std::string row(int pedestrians, std::uint64_t seed) const {
    Simulator::Params simulator = simulator_;
    simulator.pedestrians = pedestrians;
    simulator.seed = seed;
    CrowdHistory people(world_, simulator);
    const auto plan = bound_->plan(people);
    return fmt::format("{},{},{},{:.3f},{},{:.3f}\n", name_, pedestrians, seed, max_speed_,
                       plan ? fmt::format("{:.3f}", plan->arrival) : "", free_drive_);
  }

 private:
  std::string name_;
  World world_;
  Simulator::Params simulator_;
  double max_speed_ = 0.0;   // [m/s]
  double free_drive_ = 0.0;  // [s]
  std::optional<OmniscientBound> bound_;
};

// The rows of all crowds, in order.
std::vector<std::string> rowsOf(const Options& options) {
  std::deque<BoundSetup> setups;  // which stay where they are
  for (const std::string& world : options.worlds) setups.emplace_back(options, world);
  const size_t runs = static_cast<size_t>(options.runs);
  const size_t per_world = options.pedestrians.size() * runs;
  std::vector<std::string> rows(setups.size() * per_world);
  Progress progress(0, rows.size(), "crowds");
  size_t done = 0;
  Interruption::listen();
  runJobs(rows.size(), options.jobs, [&](size_t i) -> Delivery {
    Interruption::throwIfReceived();
    const int pedestrians = options.pedestrians[i % per_world / runs];
    rows[i] = setups[i / per_world].row(pedestrians, options.seed + i % runs);
    return [&] { progress.show(++done); };
  });
  return rows;
}

void run(const Options& options) {
  requireWorlds(options.worlds);
  requireDifferent("--pedestrians", options.pedestrians);
  if (!options.output.empty() && std::filesystem::exists(options.output)) {
    throw std::runtime_error(fmt::format("--output: cannot write '{}': it exists", options.output));
  }
  std::string text = "world,pedestrians,seed,max_speed_mps,bound_s,free_drive_s\n";
  try {
    for (const std::string& row : rowsOf(options)) text += row;
  } catch (const Interruption::Signal&) {
    fmt::print(stderr, "\nomniscient_bound: interrupted, nothing was written\n");
    throw;
  }
  // Into the file when all is known, for it takes little time.
  if (options.output.empty()) {
    fmt::print("{}", text);
  } else {
    replaceFile(options.output, text);
  }
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"The fastest trips of a robot that knows where everybody will be."};
  app.footer(std::string(R"(
Example, of the same people as those of run_experiments:
  omniscient_bound --pedestrians 100 400 --runs 100 --output bounds.csv
  report_experiments results.csv --bound bounds.csv
)") + kExitStatusOfLongRuns);
  Options options;
  addOptions(app, options);
  return runTool("omniscient_bound", app, argc, argv, [&] {
    run(options);
    return 0;
  });
}
