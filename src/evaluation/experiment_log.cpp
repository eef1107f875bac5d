// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/evaluation/experiment_log.h"

#include <fmt/format.h>

#include <filesystem>
#include <stdexcept>

namespace pomdp_crowd_nav {
namespace {

OrderedCsv::Layout layout(const std::string& header, const std::vector<Trial>& trials) {
  OrderedCsv::Layout layout{header, {}, true};
  for (const Trial& trial : trials) layout.keys.push_back(trialCells(trial));
  return layout;
}

void refuseIfThere(const char* option, const std::string& path) {
  if (!std::filesystem::exists(path)) return;
  throw std::runtime_error(
      fmt::format("{}: cannot write '{}': it exists; --resume goes on with it", option, path));
}

OrderedCsv openResults(const ExperimentLog::Files& files, const std::vector<Trial>& trials,
                       const ExperimentSettings& settings) {
  const OrderedCsv::Layout rows = layout(csvHeader(), trials);
  if (files.results.empty()) return OrderedCsv(rows);
  if (!files.resume) {
    refuseIfThere("--output", files.results);
    refuseIfThere("--trails", files.trails);
  }
  if (files.resume && OrderedCsv::holdsLines(files.results)) {
    requireSameSettings(settingsPath(files.results), settings);
  } else {
    writeSettings(settingsPath(files.results), settings);
  }
  return OrderedCsv(files.results, rows, files.resume);
}

}  // namespace

ExperimentLog::ExperimentLog(const Files& files, const std::vector<Trial>& trials,
                             const ExperimentSettings& settings)
    : results_(openResults(files, trials, settings)) {
  if (!files.trails.empty()) openTrails(files, trials);
}

void ExperimentLog::openTrails(const Files& files, const std::vector<Trial>& trials) {
  OrderedCsv::Layout lines = layout(trailHeader(), trials);
  lines.one_line = false;
  trails_.emplace(files.trails, lines, files.resume);
  std::vector<bool> finished(trials.size());
  for (size_t i = 0; i < trials.size(); ++i) {
    finished[i] = results_.has(i);
    if (!finished[i] || trails_->has(i)) continue;
    throw std::runtime_error(fmt::format("{}: there is no trail of the episode '{}', which {} has",
                                         files.trails, lines.keys[i], files.results));
  }
  trails_->keepOnly(finished);
}

void ExperimentLog::add(size_t index, const std::string& row, const std::string& trail) {
  if (trails_) trails_->add(index, trail);
  results_.add(index, row + "\n");
}

}  // namespace pomdp_crowd_nav
