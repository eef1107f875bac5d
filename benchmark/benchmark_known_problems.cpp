// SPDX-License-Identifier: BSD-3-Clause
// What the search earns on problems whose answer others have published.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>

#include "../test/despot/models/closed_loop.h"
#include "../test/despot/models/rock_sample_belief.h"
#include "../test/despot/models/tag_belief.h"
#include "../test/despot/models/tiger_belief.h"

using namespace pomdp_crowd_nav;

namespace {

struct Options {
  std::string problem = "rock_sample";
  std::string defaults = "plain";
  int runs = 100;
  SearchParams search;
  EpisodeParams episode;
};

// Mean discounted returns of others with K = 500 scenarios: DESPOT as published (Ye et al. 2017,
// 1 s a step) and a well-known C++ program for it at 0.1 s a step.
struct Known {
  double literature;
  double peer;  // NaN: not measured
};

void addOptions(CLI::App& app, Options& o) {
  app.add_option("--problem", o.problem, "What to play")
      ->check(CLI::IsMember({"rock_sample", "tag", "tiger"}))
      ->capture_default_str();
  app.add_option("--defaults", o.defaults, "Default policies: near the best, or next to none")
      ->check(CLI::IsMember({"smart", "plain"}))
      ->capture_default_str();
  app.add_option("--runs", o.runs, "Episodes, each with a seed of its own")
      ->check(CLI::Range(1, 1000000))
      ->capture_default_str();
  auto* time = app.add_option("--time", o.episode.time, "Wall clock of a step [s]")
                   ->check(CLI::PositiveNumber)
                   ->capture_default_str();
  app.add_option("--trials", o.episode.trials, "Trials of a step instead of a time (repeatable)")
      ->check(CLI::PositiveNumber)
      ->excludes(time);
  app.add_option("--steps", o.episode.max_steps, "Steps before an episode is broken off")
      ->check(CLI::Range(1, 10000))
      ->capture_default_str();
  app.add_option("--scenarios", o.search.scenarios, "K")->capture_default_str();
  app.add_option("--depth", o.search.max_depth, "D")->capture_default_str();
  app.add_option("--discount", o.search.discount, "gamma")->capture_default_str();
  app.add_option("--regularization", o.search.regularization, "lambda")->capture_default_str();
  app.add_option("--seed", o.episode.seed, "Of the first run; the others follow")
      ->capture_default_str();
}

template <class Belief, class MakeModel>
void play(const Options& options, const MakeModel& make_model, const Known& known) {
  Search<typename Belief::Model> search(options.search);
  double sum = 0.0;
  double squares = 0.0;
  long steps = 0;
  long trials = 0;
  long bound_violations = 0;
  for (int run = 0; run < options.runs; ++run) {
    EpisodeParams params = options.episode;
    params.seed += static_cast<std::uint64_t>(run);
    const Episode episode = runEpisode<Belief>(search, make_model, params);
    sum += episode.discounted_return;
    squares += episode.discounted_return * episode.discounted_return;
    steps += episode.steps;
    trials += episode.trials;
    bound_violations += episode.bound_violations;
    fmt::print(stderr, "run {}: return {:.2f} in {} steps, mean so far {:.2f}\n", run,
               episode.discounted_return, episode.steps, sum / (run + 1));
  }
  const double n = options.runs;
  const double variance = n > 1 ? (squares - sum * sum / n) / (n - 1) : 0.0;
  fmt::print("steps_per_run={:.1f} trials_per_step={:.0f} bound_violations={}\n", steps / n,
             static_cast<double>(trials) / static_cast<double>(steps), bound_violations);
  fmt::print(
      "problem={} runs={} mean_return={:.2f} standard_error={:.2f} literature={:.2f} peer={:.2f}\n",
      options.problem, options.runs, sum / n, std::sqrt(std::max(variance, 0.0) / n),
      known.literature, known.peer);
}

void playProblem(const Options& options) {
  const double discount = options.search.discount;
  const Defaults defaults = options.defaults == "smart" ? Defaults::kSmart : Defaults::kPlain;
  if (options.problem == "rock_sample") {
    RockSampleMap map;
    map.discount = discount;
    const RockSampleTables tables(map);
    const auto make = [&tables, defaults](std::uint64_t seed) {
      return RockSample(tables, seed, defaults);
    };
    play<RockSampleBelief>(options, make, {20.93, 20.1});
  } else if (options.problem == "tag") {
    const TagValues values(discount);
    const auto make = [&values, defaults](std::uint64_t seed) {
      return Tag(values, seed, defaults);
    };
    play<TagBelief>(options, make, {-6.23, -6.39});
  } else {
    const auto make = [&options](std::uint64_t seed) {
      return Tiger({options.search.discount, options.search.max_depth, seed});
    };
    play<TigerBelief>(options, make, {tigerOptimum(discount), std::nan("")});
  }
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  options.search.scenarios = 500;
  options.search.max_depth = 90;
  options.search.discount = 0.95;
  options.episode.time = 0.1;
  CLI::App app{"Plays problems with known answers"};
  addOptions(app, options);
  CLI11_PARSE(app, argc, argv);
  if (app.count("--trials") > 0) options.episode.time = 0.0;
  try {
    playProblem(options);
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 1;
  }
  return 0;
}
