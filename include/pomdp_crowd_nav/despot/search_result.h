// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace pomdp_crowd_nav {

enum class SearchStop {
  kGapClosed,   // the root's bounds met
  kTrialLimit,  // all trials were used
  kDeadline,    // time was up
  kNodeLimit,   // the tree has as many nodes or as much memory as it may
  kLowerBound,  // the root's lower bound is as high as was asked for
};

const char* describe(SearchStop stop);

struct SearchStatistics {
  long trials = 0;
  long expansions = 0;
  long belief_nodes = 0;
  long model_steps = 0;       // steps of one scenario, roll-outs included
  long bound_violations = 0;  // leaves whose lower bound was above the upper; clamped
  long tree_bytes = 0;
  double lower_bound = 0.0;  // of the root, regularised
  double upper_bound = 0.0;  // of the root, regularised
  double initial_lower_bound = 0.0;
  double initial_upper_bound = 0.0;
  SearchStop stop = SearchStop::kGapClosed;

  double gap() const { return upper_bound - lower_bound; }
};

template <class Action>
struct SearchResult {
  Action action;              // best legal action at the root
  bool from_default = false;  // true: no node was expanded, the model's default action was taken
  std::vector<Action> plan;   // best action at each depth along the most likely branch
  SearchStatistics statistics;
};

}  // namespace pomdp_crowd_nav
