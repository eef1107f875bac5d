// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/evaluation/omniscient_bound.h"

#include "config_files.h"
#include "episode_params.h"
#include "interruption.h"
#include "option_checks.h"
#include "pomdp_crowd_nav/evaluation/durable_file.h"
#include "pomdp_crowd_nav/planner/navigation_tables.h"
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
  app.add_option("--profile", options.profile,
                 "Name in config/profiles, or a yaml file: the vehicle and its clearances; without "
                 "it paper for the worlds scenario_*, street for the others");
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
  PriorParams prior = navigation.planning.prior;
  const ModelParams& model = navigation.planning.model;
  prior.clearance = model.obstacleClearance();
  const StaticMap map = world.map();
  const NavigationTables tables(makePrior("fast_marching", map, world.goal, prior), map, model,
                                prior.resolution);
  if (!tables.shortest_way) return bound.beelineTime();
  const Point& start = world.start.position;
  const double way =
      tables.shortest_way->lengthFrom(static_cast<float>(start.x()), static_cast<float>(start.y()));
  return std::max(bound.beelineTime(), start_delay + way / model.vehicle.max_speed);
}

class Run {
 public:
  explicit Run(const Options& options)
      : options_(options),
        progress_(0, options.worlds.size() * options.pedestrians.size() * options.runs, "crowds") {
    if (!options.output.empty() && std::filesystem::exists(options.output)) {
      throw std::runtime_error(
          fmt::format("--output: cannot write '{}': it exists", options.output));
    }
  }

  // Into the file when all is known, for it takes little time.
  void run() {
    for (const std::string& world : options_.worlds) runWorld(world);
    if (options_.output.empty()) {
      fmt::print("{}", text_);
    } else {
      replaceFile(options_.output, text_);
    }
  }

 private:
  void runWorld(const std::string& name) {
    const std::string profile = options_.profile.empty() ? profileFor(name) : options_.profile;
    YamlParamReader reader = openProfile(options_.config, profile, {});
    const EpisodeParams episode = loadEpisodeParams(reader);
    const NavigationParams& navigation = episode.navigation;
    const ModelParams& model = navigation.planning.model;
    Simulator::Params simulator = episode.simulator;
    World world = loadWorld(configFile(options_.config, "worlds", name));
    if (!options_.tracks.empty()) world.tracks_file = options_.tracks;
    const OmniscientBound::Params params = boundParams(model);
    const OmniscientBound bound(world, params);
    if (!std::isfinite(bound.emptyDriveTime())) {
      throw std::runtime_error(fmt::format("{}: no way to the goal", world.name));
    }
    const double free_drive = freeDriveTime(world, navigation, bound, params.start_delay);
    for (const int pedestrians : options_.pedestrians) {
      for (int i = 0; i < options_.runs; ++i) {
        simulator.pedestrians = pedestrians;
        simulator.seed = options_.seed + static_cast<std::uint64_t>(i);
        CrowdHistory people(world, simulator);
        Interruption::throwIfReceived();
        const auto plan = bound.plan(people);
        text_ += fmt::format("{},{},{},{:.3f},{},{:.3f}\n", name, pedestrians, simulator.seed,
                             params.max_speed, plan ? fmt::format("{:.3f}", plan->arrival) : "",
                             free_drive);
        progress_.show(++done_);
      }
    }
  }

  const Options& options_;
  Progress progress_;
  std::string text_ = "world,pedestrians,seed,max_speed_mps,bound_s,free_drive_s\n";
  size_t done_ = 0;
};

void run(const Options& options) {
  Run run(options);
  Interruption::listen();
  try {
    run.run();
  } catch (const Interruption::Signal&) {
    fmt::print(stderr, "\nomniscient_bound: interrupted, nothing was written\n");
    throw;
  }
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"The fastest trips of a robot that knows where everybody will be."};
  Options options;
  addOptions(app, options);
  return runTool("omniscient_bound", app, argc, argv, [&] {
    run(options);
    return 0;
  });
}
