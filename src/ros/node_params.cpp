// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/ros/node_params.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "pomdp_crowd_nav/planner/planner_factory.h"

namespace pomdp_crowd_nav {
namespace {

// Decisions start and end this early at least, see DecisionSchedule.
constexpr double kShortestStep = 0.2;  // [s]

FrameNames readFrames(ParamReader& reader) {
  FrameNames frames;
  reader.read("global_frame", frames.global);
  reader.read("odom_frame", frames.odom);
  reader.read("robot_base_frame", frames.base);
  return frames;
}

void requireKnownPlanner(const std::string& name) {
  const std::vector<std::string> names = plannerNames();
  if (std::find(names.begin(), names.end(), name) != names.end()) return;
  std::string known;
  for (const std::string& other : names) known += (known.empty() ? "" : ", ") + other;
  throw std::invalid_argument(fmt::format("planner must be one of {}, got '{}'", known, name));
}

// Keys of the libraries that live in the same namespace, and are theirs to read.
void acceptLibraryKeys(ParamReader& reader) {
  double ignored = 0.0;
  reader.read("diagnostic_period", ignored);
  reader.read("actionlib_status_frequency", ignored);
}

}  // namespace

PlannerNodeParams loadPlannerNodeParams(ParamReader& reader) {
  PlannerNodeParams params;
  params.navigation = loadNavigationParams(reader);
  loadSimulatorParams(reader, params.navigation.planning.model.vehicle);  // a profile serves both
  params.frames = readFrames(reader);
  reader.read("world_file", params.world_file);
  reader.read("map_timeout", params.map_timeout);
  int seed = static_cast<int>(params.navigation.planning.seed);
  reader.read("seed", seed);
  params.navigation.planning.seed = static_cast<std::uint64_t>(seed);
  const bool has_destinations = reader.read("destinations", params.destinations);
  acceptLibraryKeys(reader);
  reader.requireAllUsed();
  requireKnownPlanner(params.navigation.planner);
  if (params.navigation.planning.model.step < kShortestStep) {
    throw std::invalid_argument(fmt::format("planner_frequency must be at most {} Hz, got {}",
                                            1.0 / kShortestStep,
                                            1.0 / params.navigation.planning.model.step));
  }
  if (params.map_timeout < 0.0) {
    throw std::invalid_argument(
        fmt::format("map_timeout must not be negative, got {}", params.map_timeout));
  }
  if (!has_destinations && !params.world_file.empty()) {
    params.destinations = loadWorld(params.world_file).destinations;
  }
  if (params.destinations.empty()) {
    throw std::invalid_argument("no destinations of people: set ~destinations or ~world_file");
  }
  return params;
}

SimNodeParams loadSimNodeParams(ParamReader& reader) {
  SimNodeParams params;
  params.navigation = loadNavigationParams(reader);
  params.simulator = loadSimulatorParams(reader, params.navigation.planning.model.vehicle);
  params.frames = readFrames(reader);
  reader.read("world_file", params.world_file);
  reader.read("tracks_file", params.tracks_file);
  reader.read("pedestrians", params.simulator.pedestrians);
  reader.read("map_resolution", params.map_resolution);
  int seed = static_cast<int>(params.simulator.seed);
  reader.read("seed", seed);
  params.simulator.seed = static_cast<std::uint64_t>(seed);
  reader.requireAllUsed();
  if (params.world_file.empty())
    throw std::invalid_argument("no world to simulate: set ~world_file");
  if (params.map_resolution <= 0.0) {
    throw std::invalid_argument(
        fmt::format("map_resolution must be positive, got {}", params.map_resolution));
  }
  return params;
}

World loadSimWorld(const SimNodeParams& params) {
  World world = loadWorld(params.world_file);
  if (!params.tracks_file.empty()) world.tracks_file = params.tracks_file;
  return world;
}

}  // namespace pomdp_crowd_nav
