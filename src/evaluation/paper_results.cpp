// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/evaluation/paper_results.h"

#include <fmt/format.h>

#include <filesystem>
#include <stdexcept>
#include <vector>

#include "pomdp_crowd_nav/params/number_text.h"
#include "pomdp_crowd_nav/params/yaml_param_reader.h"

namespace pomdp_crowd_nav {

PaperResults PaperResults::fromFile(const std::string& path) {
  auto reader = YamlParamReader::fromFile(path);
  PaperResults results;
  for (const auto& [key, text] : reader.texts()) {
    std::vector<std::vector<double>> rows;
    reader.read(key, rows);
    for (const std::vector<double>& row : rows) {
      if (row.size() != 5 && row.size() != 6) {
        throw std::runtime_error(
            fmt::format("{}: {}: expected rows of 5 or 6 numbers, got {}", path, key, toText(row)));
      }
      PaperResult& result = results.results_[fmt::format("{}/{:.0f}", key, row[0])];
      result = {row[1], row[2], row[3], row[4], std::nullopt};
      if (row.size() == 6) result.pairs_won = static_cast<int>(row[5]);
    }
  }
  return results;
}

std::optional<PaperResult> PaperResults::find(const std::string& vehicle,
                                              const std::string& planner, const std::string& world,
                                              int pedestrians) const {
  const std::string name = std::filesystem::path(world).stem().string();
  const auto found = results_.find(fmt::format("{}/{}/{}/{}", vehicle, planner, name, pedestrians));
  if (found == results_.end()) return std::nullopt;
  return found->second;
}

}  // namespace pomdp_crowd_nav
