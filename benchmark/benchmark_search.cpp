// SPDX-License-Identifier: BSD-3-Clause
// How much the search gets done in the time of a decision, on twenty crowds (search_rig.h).
#include <fmt/format.h>
#include <sys/resource.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <limits>
#include <string>
#include <vector>

#include "search_rig.h"

using namespace pomdp_crowd_nav;

namespace {

struct Options {
  SearchRigParams rig;
  double time = 0.5;
  int crowds = 20;
  std::uint64_t seed = 1;
  std::string upper_bound = "tight";
};

void addOptions(CLI::App& app, Options& options) {
  app.add_option("--time", options.time, "Wall clock of a decision [s]")
      ->check(CLI::Range(1e-3, 3600.0))
      ->capture_default_str();
  app.add_option("--crowds", options.crowds, "Crowds to decide in, one decision each")
      ->check(CLI::Range(1, 1000000))
      ->capture_default_str();
  app.add_option("--seed", options.seed, "Seed of the first crowd; the others follow")
      ->capture_default_str();
  app.add_option("--threads", options.rig.threads, "Threads of the search")
      ->check(CLI::Range(1, 64))
      ->capture_default_str();
  app.add_option("--scenarios", options.rig.scenarios, "Sampled futures K")
      ->check(CLI::Range(1, 10000))
      ->capture_default_str();
  app.add_option("--depth", options.rig.depth, "Depth of the search D, steps of 1 s")
      ->check(CLI::Range(1, 2000))
      ->capture_default_str();
  app.add_option("--pedestrians", options.rig.pedestrians, "People about the robot")
      ->check(CLI::Range(0, 100))
      ->capture_default_str();
  app.add_option("--upper-bound", options.upper_bound, "Bound on the value of a leaf")
      ->check(CLI::IsMember({"paper", "tight"}))
      ->capture_default_str();
  app.add_option("--bold-rollouts", options.rig.bold_rollouts,
                 "Value a leaf by the better of two roll-outs; false is the paper's rule")
      ->capture_default_str();
}

// Root lower bounds whose time is taken; what a well-known C++ DESPOT reaches in 0.5 s.
constexpr double kTargets[] = {125.7, 148.0};

struct Row {
  SearchStatistics search;
  double wall_time = 0.0;            // [s]
  double seconds_to_target[2] = {};  // infinite: not reached in the time of a decision
};

SearchLimit limitOf(double seconds) {
  return SearchLimit::until(SearchLimit::Clock::now() +
                            std::chrono::duration_cast<SearchLimit::Clock::duration>(
                                std::chrono::duration<double>(seconds)));
}

double secondsToTarget(SearchRig& rig, std::uint64_t crowd, double time, double target) {
  SearchLimit limit = limitOf(time);
  limit.lower_bound = target;
  const SearchRig::Decision decision = rig.decide(crowd, limit);
  const bool is_reached = decision.search.lower_bound >= target;
  return is_reached ? decision.wall_time : std::numeric_limits<double>::infinity();
}

Row decideIn(SearchRig& rig, std::uint64_t crowd, double time) {
  Row row;
  const SearchRig::Decision decision = rig.decide(crowd, limitOf(time));
  row.search = decision.search;
  row.wall_time = decision.wall_time;
  for (int i = 0; i < 2; ++i) {
    row.seconds_to_target[i] = secondsToTarget(rig, crowd, time, kTargets[i]);
  }
  return row;
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

template <class Figure>
double medianOf(const std::vector<Row>& rows, Figure figure) {
  std::vector<double> values;
  for (const Row& row : rows) values.push_back(static_cast<double>(figure(row)));
  return median(values);
}

double peakMegabytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

void printRow(int crowd, const Row& row) {
  const SearchStatistics& s = row.search;
  fmt::print(
      "{:>5} {:>10.1f} {:>7} {:>10} {:>9} {:>8.2f} {:>8.2f} {:>6.2f} {:>8.4f} {:>8.4f} {:>8.4f}\n",
      crowd, static_cast<double>(s.model_steps) / row.wall_time * 1e-6, s.trials, s.expansions,
      s.belief_nodes, s.lower_bound, s.upper_bound, s.gap(), row.seconds_to_target[0],
      row.seconds_to_target[1], row.wall_time);
  std::fflush(stdout);
}

void printMedians(const std::vector<Row>& rows) {
  double longest = 0.0;
  for (const Row& row : rows) longest = std::max(longest, row.wall_time);
  fmt::print(
      "model_steps_per_s={:.4g} trials={:.0f} expansions={:.0f} belief_nodes={:.0f} "
      "lower_bound={:.2f} upper_bound={:.2f} gap={:.2f} time_to_lower_bound_125_7_s={:.4f} "
      "time_to_lower_bound_148_s={:.4f} decision_wall_max_s={:.4f} peak_rss_mb={:.0f}\n",
      medianOf(rows, [](const Row& r) { return r.search.model_steps / r.wall_time; }),
      medianOf(rows, [](const Row& r) { return r.search.trials; }),
      medianOf(rows, [](const Row& r) { return r.search.expansions; }),
      medianOf(rows, [](const Row& r) { return r.search.belief_nodes; }),
      medianOf(rows, [](const Row& r) { return r.search.lower_bound; }),
      medianOf(rows, [](const Row& r) { return r.search.upper_bound; }),
      medianOf(rows, [](const Row& r) { return r.search.gap(); }),
      medianOf(rows, [](const Row& r) { return r.seconds_to_target[0]; }),
      medianOf(rows, [](const Row& r) { return r.seconds_to_target[1]; }), longest,
      peakMegabytes());
}

void decideInAll(const Options& options) {
  SearchRig rig(options.rig);
  fmt::print(
      "crowd   Msteps/s   trials expansions   beliefs    lower    upper    gap  to125.7    to148 "
      "    wall\n");
  std::vector<Row> rows;
  for (int i = 0; i < options.crowds; ++i) {
    rows.push_back(decideIn(rig, options.seed + static_cast<std::uint64_t>(i), options.time));
    printRow(i + 1, rows.back());
  }
  printMedians(rows);
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  CLI::App app{"Searches one decision in each of many crowds and prints what the search got done"};
  addOptions(app, options);
  try {
    app.parse(argc, argv);
    options.rig.upper_bound =
        options.upper_bound == "paper" ? UpperBoundKind::kPaper : UpperBoundKind::kTight;
    decideInAll(options);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  } catch (const std::exception& error) {
    fmt::print(stderr, "benchmark_search: {}\n", error.what());
    return 2;
  }
  return 0;
}
