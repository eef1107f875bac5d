// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pomdp_crowd_nav/despot/noise_streams.h"
#include "pomdp_crowd_nav/despot/search.h"
#include "weighted_states.h"

namespace pomdp_crowd_nav {

struct EpisodeParams {
  int max_steps = 90;
  double time = 0.0;  // [s] of a search; 0: by trials
  long trials = 100;
  std::uint64_t seed = 1;
};

struct Episode {
  double discounted_return = 0.0;
  int steps = 0;
  bool ended = false;  // by itself, before the last step
  long trials = 0;
  long bound_violations = 0;
};

// Plays a problem to its end: search, act in a true state that nobody sees, update the exact
// belief. Every search and the truth have noise of their own.
//   Belief     has  type Model, Belief(const Model&), states() with their weights,
//                   update(const Model&, action, observation)
//   MakeModel  makes a Model from the seed of its noise
template <class Belief, class MakeModel>
Episode runEpisode(Search<typename Belief::Model>& search, const MakeModel& make_model,
                   const EpisodeParams& params) {
  using Model = typename Belief::Model;
  const NoiseStreams seeds(params.seed);
  const Model truth = make_model(seeds.bits(0, 0, 0));
  Belief belief(truth);
  typename Model::State state = drawStates(belief.states(), 1, seeds.uniform(0, 0, 1))[0];
  Episode episode;
  double discount = 1.0;
  while (!episode.ended && episode.steps < params.max_steps) {
    const Model model = make_model(seeds.bits(1, episode.steps, 0));
    SearchLimit limit = SearchLimit::trials(params.trials);
    if (params.time > 0.0) {
      limit = SearchLimit::until(SearchLimit::Clock::now() +
                                 std::chrono::duration_cast<SearchLimit::Clock::duration>(
                                     std::chrono::duration<double>(params.time)));
    }
    const auto scenarios =
        drawStates(belief.states(), search.params().scenarios, seeds.uniform(1, episode.steps, 1));
    const auto result = search.run(model, scenarios, limit);
    typename Model::State next = state;
    const Branch branch = truth.step(state, 0, episode.steps, result.action, next);
    belief.update(truth, result.action, branch.observation);
    state = next;
    episode.discounted_return += discount * static_cast<double>(branch.reward);
    discount *= search.params().discount;
    episode.ended = branch.terminal;
    episode.trials += result.statistics.trials;
    episode.bound_violations += result.statistics.bound_violations;
    ++episode.steps;
  }
  return episode;
}

}  // namespace pomdp_crowd_nav
