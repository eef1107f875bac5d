// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fmt/format.h>

#include <stdexcept>
#include <string>
#include <vector>

#include "config_files.h"
#include "pomdp_crowd_nav/evaluation/episode.h"
#include "pomdp_crowd_nav/params/yaml_param_reader.h"

namespace pomdp_crowd_nav {

// A profile, by its name or file, with the keys that `replaced` (KEY=VALUE) says otherwise.
inline YamlParamReader openProfile(const std::string& config, const std::string& profile,
                                   const std::vector<std::string>& replaced) {
  auto reader = YamlParamReader::fromFile(configFile(config, "profiles", profile));
  for (const std::string& assignment : replaced) {
    if (assignment.rfind("planner=", 0) == 0) {
      throw std::runtime_error(
          fmt::format("--set: got '{}', a planner has an option of its own", assignment));
    }
    reader.replace(assignment);
  }
  return reader;
}

inline EpisodeParams loadEpisodeParams(YamlParamReader& reader) {
  EpisodeParams params;
  params.navigation = loadNavigationParams(reader);
  params.simulator = loadSimulatorParams(reader, params.navigation.planning.model.vehicle);
  reader.requireAllUsed();
  return params;
}

}  // namespace pomdp_crowd_nav
