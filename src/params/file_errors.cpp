// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/params/file_errors.h"

#include <fmt/format.h>

#include <filesystem>
#include <vector>

#include "pomdp_crowd_nav/params/closest_name.h"

namespace pomdp_crowd_nav {
namespace {

// The file beside it that may have been meant.
std::string hintAt(const std::filesystem::path& path) {
  constexpr size_t kMostFiles = 1000;  // in a folder that is searched
  std::error_code error;
  if (std::filesystem::exists(path, error)) return "";
  std::vector<std::string> names;
  const auto folder = path.has_parent_path() ? path.parent_path() : std::filesystem::path(".");
  for (auto entry = std::filesystem::directory_iterator(folder, error);
       !error && entry != std::filesystem::directory_iterator() && names.size() < kMostFiles;
       entry.increment(error)) {
    if (entry->path().extension() == path.extension()) {
      names.push_back(entry->path().filename().string());
    }
  }
  return didYouMean(path.filename().string(), names);
}

}  // namespace

std::string cannotBeRead(const std::string& path) {
  std::error_code none;
  const std::string folder = std::filesystem::current_path(none).string();
  const bool is_relative = std::filesystem::path(path).is_relative();
  const std::string where = is_relative ? fmt::format(" (looked for in {})", folder) : "";
  return fmt::format("{}: the file cannot be read{}{}", path, where, hintAt(path));
}

}  // namespace pomdp_crowd_nav
