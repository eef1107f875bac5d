// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <limits>

namespace pomdp_crowd_nav {

// Knobs of the DESPOT search; symbols as in Ye, Somani, Hsu, Lee, "DESPOT: Online POMDP Planning
// with Regularization", JAIR 2017.
struct SearchParams {
  int scenarios = 100;           // K, sampled futures
  int max_depth = 100;           // D, steps a trial may descend
  double discount = 0.97;        // gamma, per step
  double regularization = 0.01;  // lambda, cost of one node of the policy tree
  double target_gap = 0.95;      // xi, share of the root gap a trial tries to keep
  int max_nodes = 1'500'000;     // belief nodes; a tree this large is not expanded further
  double max_memory = 140.0;     // [MB], the same for what the tree holds
  int threads = 1;               // that run trials; with more than one no result is reproducible
};

// Throws std::invalid_argument naming the first field that is out of range.
void validate(const SearchParams& params);
inline const SearchParams& validated(const SearchParams& params) {
  validate(params);
  return params;
}

// When to stop: whichever comes first.
struct SearchLimit {
  using Clock = std::chrono::steady_clock;
  Clock::time_point deadline = Clock::time_point::max();
  long max_trials = std::numeric_limits<long>::max();
  double lower_bound = std::numeric_limits<double>::infinity();  // of the root: good enough

  static SearchLimit trials(long count) {
    SearchLimit limit;
    limit.max_trials = count;
    return limit;
  }
  static SearchLimit until(Clock::time_point time) {
    SearchLimit limit;
    limit.deadline = time;
    return limit;
  }
};

}  // namespace pomdp_crowd_nav
