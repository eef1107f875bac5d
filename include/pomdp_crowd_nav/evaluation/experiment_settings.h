// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>

#include "pomdp_crowd_nav/evaluation/experiment.h"

namespace pomdp_crowd_nav {

// What a results file was written with, kept beside it as json: all that decides on its rows.
struct ExperimentSettings {
  struct WorldSettings {
    std::string profile;                            // name or file
    std::string vehicle;                            // "holonomic" or "car"
    std::map<std::string, std::string> parameters;  // of the profile, with what replaces them
    std::map<std::string, std::string> world;       // of the world file
    std::string recording;  // fingerprint of the recorded people; empty: none
  };

  std::string version;  // of the program; empty in files of programs that did not tell
  ExperimentPlan plan;
  long max_trials = 0;                // per decision; 0: search_time counts
  double search_time = 0.0;           // [s]
  std::string tracks;                 // file of recorded people; empty: none
  std::vector<std::string> replaced;  // KEY=VALUE, as given
  std::map<std::string, WorldSettings> worlds;
};

// Tells a file's content from any other that is likely; throws std::runtime_error with one line.
std::string fingerprintOf(const std::string& path);

std::string settingsPath(const std::string& results_path);

// All throw std::runtime_error with one line that names the file.
void writeSettings(const std::string& path, const ExperimentSettings& settings);
ExperimentSettings readSettings(const std::string& path);
// Names the first setting that is another one in the file. Of another version of the program the
// rows may be others too.
void requireSameSettings(const std::string& path, const ExperimentSettings& settings);

}  // namespace pomdp_crowd_nav
