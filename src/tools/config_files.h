// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "pomdp_crowd_nav/params/closest_name.h"

namespace pomdp_crowd_nav {

// The folder of worlds and profiles: `config` where the program is started, else that of the
// installation that the program lies in, else that of the sources it was built from.
inline std::string findConfigFolder() {
  namespace fs = std::filesystem;
  std::error_code none;
  const fs::path program = fs::read_symlink("/proc/self/exe", none);
  const fs::path share = program.parent_path().parent_path().parent_path() / "share";
  for (const fs::path& folder : {fs::path("config"), share / "pomdp_crowd_nav" / "config"}) {
    if (fs::is_directory(folder / "profiles", none)) return folder.string();
  }
  return SOURCE_DIR "/config";
}

// Names of the yaml files of a folder, in order.
inline std::vector<std::string> namesIn(const std::filesystem::path& folder) {
  std::vector<std::string> names;
  std::error_code none;
  for (const auto& entry : std::filesystem::directory_iterator(folder, none)) {
    if (entry.path().extension() == ".yaml") names.push_back(entry.path().stem().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

// The file that an option means: a path, or a name in a folder of `config`.
inline std::string configFile(const std::string& config, const char* kind,
                              const std::string& name) {
  namespace fs = std::filesystem;
  const fs::path path(name);
  const bool is_file =
      path.has_parent_path() || path.extension() == ".yaml" || path.extension() == ".yml";
  if (is_file) return name;
  const fs::path folder = fs::path(config) / kind;
  std::error_code none;
  if (!fs::is_directory(folder, none)) {
    throw std::runtime_error(fmt::format("--config: there is no folder '{}'", folder.string()));
  }
  const std::string file = (folder / (name + ".yaml")).string();
  if (fs::exists(file, none)) return file;
  const std::vector<std::string> known = namesIn(folder);
  throw std::runtime_error(
      fmt::format("there is no '{}' in {}; choose one of: {}, or give a file{}", name,
                  folder.string(), commaSeparated(known), didYouMean(name, known)));
}

// As simulation.launch chooses it.
inline std::string profileFor(const std::string& world) {
  const std::string name = std::filesystem::path(world).stem().string();
  return name.rfind("scenario_", 0) == 0 ? "paper" : "street";
}

}  // namespace pomdp_crowd_nav
