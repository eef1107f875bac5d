// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <optional>
#include <string>

namespace pomdp_crowd_nav {

// A cell of the paper's Tables 1 and 2.
struct PaperResult {
  double travel_time = 0.0;        // [s]
  double travel_time_error = 0.0;  // [s], standard error
  double sudden_brakes = 0.0;
  double sudden_brakes_error = 0.0;
  std::optional<int> pairs_won;  // of 100 against 1d_astar
};

// What the paper publishes, from config/paper_results.yaml.
class PaperResults {
 public:
  PaperResults() = default;  // nothing
  // Throws std::runtime_error with one line that names the file.
  static PaperResults fromFile(const std::string& path);

  // Nothing where the paper has no such cell. `world`: its name or file.
  std::optional<PaperResult> find(const std::string& vehicle, const std::string& planner,
                                  const std::string& world, int pedestrians) const;

 private:
  std::map<std::string, PaperResult> results_;  // by vehicle/planner/world/pedestrians
};

}  // namespace pomdp_crowd_nav
