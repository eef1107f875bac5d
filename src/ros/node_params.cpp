// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/ros/node_params.h"

#include <fmt/format.h>

#include <cstdint>
#include <stdexcept>

namespace pomdp_crowd_nav {
namespace {

FrameNames readFrames(ParamReader& reader) {
  FrameNames frames;
  reader.read("global_frame", frames.global);
  reader.read("odom_frame", frames.odom);
  reader.read("robot_base_frame", frames.base);
  return frames;
}

std::uint64_t readSeed(ParamReader& reader, std::uint64_t preset) {
  int seed = static_cast<int>(preset);
  reader.read("seed", seed);
  if (seed >= 0) return static_cast<std::uint64_t>(seed);
  throw std::invalid_argument(fmt::format("seed must not be negative, got {}", seed));
}

void requireMapPolicy(const std::string& unknown, int occupied_threshold) {
  if (unknown != "obstacle" && unknown != "free") {
    throw std::invalid_argument(
        fmt::format("map/unknown must be 'obstacle' or 'free', got '{}'", unknown));
  }
  if (occupied_threshold < 1 || occupied_threshold > 100) {
    throw std::invalid_argument(fmt::format(
        "map/occupied_threshold must be between 1 and 100, got {}", occupied_threshold));
  }
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
  std::string unknown = "obstacle";
  reader.read("map/unknown", unknown);
  reader.read("map/occupied_threshold", params.map.occupied_threshold);
  params.navigation.planning.seed = readSeed(reader, params.navigation.planning.seed);
  const bool has_destinations = reader.read("destinations", params.destinations);
  acceptLibraryKeys(reader);
  reader.requireAllUsed();
  if (params.map_timeout < 0.0) {
    throw std::invalid_argument(
        fmt::format("map_timeout must not be negative, got {}", params.map_timeout));
  }
  requireMapPolicy(unknown, params.map.occupied_threshold);
  if (unknown == "free") params.map.unknown = UnknownSpace::kFree;
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
  params.simulator.seed = readSeed(reader, params.simulator.seed);
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
