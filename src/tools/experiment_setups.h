// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fmt/format.h>

#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "config_files.h"
#include "episode_params.h"
#include "pomdp_crowd_nav/evaluation/experiment_settings.h"

namespace pomdp_crowd_nav {

// A world with the vehicle and the tuning for it.
struct Setup {
  World world;
  EpisodeParams params;
};

// Where the setups of an experiment come from.
struct SetupSource {
  std::string config;                 // folder
  std::string profile;                // empty: as simulation.launch chooses it
  std::vector<std::string> replaced;  // KEY=VALUE of the profile
};

inline EpisodeParams paramsOf(const Trial& trial, EpisodeParams params) {
  params.navigation.planner = trial.planner;
  params.simulator.pedestrians = trial.pedestrians;
  params.seed = trial.seed;
  return params;
}

// By the name of the world. Fills in the settings of each world and, where none is asked for, the
// planner of the profile.
class Setups {
 public:
  Setups(const SetupSource& source, ExperimentSettings& settings) {
    for (const std::string& world : settings.plan.worlds) load(source, world, settings);
    if (settings.plan.planners.empty()) settings.plan.planners = {commonPlanner(settings)};
  }

  const Setup& of(const std::string& world) const { return setups_.at(world); }

  // Throws where a planner of the plan cannot drive in one of its worlds.
  void requireAllDrivable(const ExperimentPlan& plan) const {
    for (const std::string& world : plan.worlds) {
      const Setup& setup = of(world);
      for (const std::string& planner : plan.planners) {
        requireDrivable(setup.world, paramsOf({world, plan.pedestrians[0], planner}, setup.params));
      }
    }
  }

 private:
  void load(const SetupSource& source, const std::string& name, ExperimentSettings& settings) {
    const std::string profile = source.profile.empty() ? profileFor(name) : source.profile;
    YamlParamReader reader = openProfile(source.config, profile, source.replaced);
    const std::string world_file = configFile(source.config, "worlds", name);
    Setup setup{loadWorld(world_file), loadEpisodeParams(reader)};
    if (!settings.tracks.empty()) setup.world.tracks_file = settings.tracks;
    setup.params.tables = std::make_shared<SharedTables>();
    setup.params.max_trials = settings.max_trials;
    if (settings.max_trials == 0) setup.params.navigation.search_time = settings.search_time;
    const VehicleKind kind = setup.params.navigation.planning.model.vehicle.kind;
    const std::string& recording = setup.world.tracks_file;
    settings.worlds[name] = {profile, kind == VehicleKind::kCar ? "car" : "holonomic",
                             reader.texts(), YamlParamReader::fromFile(world_file).texts(),
                             recording.empty() ? "" : fingerprintOf(recording)};
    setups_.emplace(name, std::move(setup));
  }

  std::string commonPlanner(const ExperimentSettings& settings) const {
    const std::vector<std::string>& worlds = settings.plan.worlds;
    const std::string& planner = of(worlds[0]).params.navigation.planner;
    for (const std::string& world : worlds) {
      const std::string& other = of(world).params.navigation.planner;
      if (other == planner) continue;
      throw std::runtime_error(
          fmt::format("--planners: give one, the profiles for {} and {} differ: {} and {}",
                      worlds[0], world, planner, other));
    }
    return planner;
  }

  std::map<std::string, Setup> setups_;
};

}  // namespace pomdp_crowd_nav
