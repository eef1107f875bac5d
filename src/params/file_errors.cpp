// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/params/file_errors.h"

#include <fmt/format.h>

#include <filesystem>

namespace pomdp_crowd_nav {

std::string cannotBeRead(const std::string& path) {
  std::error_code none;
  const std::string folder = std::filesystem::current_path(none).string();
  const bool is_relative = std::filesystem::path(path).is_relative();
  const std::string where = is_relative ? fmt::format(" (looked for in {})", folder) : "";
  return fmt::format("{}: the file cannot be read{}", path, where);
}

}  // namespace pomdp_crowd_nav
