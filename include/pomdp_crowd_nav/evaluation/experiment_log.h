// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "pomdp_crowd_nav/evaluation/experiment_settings.h"
#include "pomdp_crowd_nav/evaluation/ordered_csv.h"

namespace pomdp_crowd_nav {

// The files of an experiment: results with their settings beside them and, if wanted, trails. An
// episode is done once its row is there, and its trail before it; a program that is killed at any
// moment loses no episode that is done.
class ExperimentLog {
 public:
  struct Files {
    std::string results;  // empty: standard output
    std::string trails;   // empty: none
    bool resume = false;  // goes on with files that are there, which otherwise are refused
  };

  // Throws std::runtime_error with one line for files that cannot be gone on with.
  ExperimentLog(const Files& files, const std::vector<Trial>& trials,
                const ExperimentSettings& settings);

  bool has(size_t index) const { return results_.has(index); }
  size_t count() const { return results_.count(); }
  // Whether the results ended in the middle of a line, which is not there any more.
  bool hasDroppedLine() const { return results_.hasDroppedLine(); }

  // `row` without, `trail` with the ends of its lines.
  void add(size_t index, const std::string& row, const std::string& trail);

 private:
  void openTrails(const Files& files, const std::vector<Trial>& trials);

  OrderedCsv results_;
  std::optional<OrderedCsv> trails_;
};

}  // namespace pomdp_crowd_nav
