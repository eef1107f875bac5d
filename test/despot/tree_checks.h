// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include "models/closed_loop.h"

namespace pomdp_crowd_nav {

// One line for every node, with its bounds to the last bit.
template <class Model>
std::vector<std::vector<float>> describeTree(const Search<Model>& search) {
  std::vector<std::vector<float>> lines;
  for (const BeliefNode& node : search.tree().beliefs) {
    lines.push_back({node.lower, node.upper, node.utility_upper, node.default_value,
                     static_cast<float>(node.parent), static_cast<float>(node.scenario_count)});
  }
  return lines;
}

template <class Model>
void expectOrderedBounds(const Search<Model>& search) {
  for (const BeliefNode& node : search.tree().beliefs) {
    ASSERT_LE(node.default_value, node.lower);
    ASSERT_LE(node.lower, node.upper);
    ASSERT_LE(node.upper, node.utility_upper);
  }
}

// Scenarios of one belief cannot be told apart, so that a policy does the same in all of them.
template <class Model>
void expectOneDefaultActionInEachBelief(const Search<Model>& search, const Model& model) {
  const auto& tree = search.tree();
  for (const BeliefNode& node : tree.beliefs) {
    const auto* states = &tree.states[node.first_state];
    for (int i = 1; i < node.scenario_count; ++i) {
      ASSERT_EQ(model.defaultAction(states + i), model.defaultAction(states));
    }
  }
}

struct Episodes {
  double mean_return = 0.0;
  long bound_violations = 0;
  int unfinished = 0;
};

template <class Belief, class MakeModel>
Episodes playEpisodes(Search<typename Belief::Model>& search, const MakeModel& make_model,
                      int count, long trials) {
  Episodes all;
  EpisodeParams params;
  params.trials = trials;
  for (params.seed = 1; params.seed <= static_cast<std::uint64_t>(count); ++params.seed) {
    const Episode episode = runEpisode<Belief>(search, make_model, params);
    all.mean_return += episode.discounted_return / count;
    all.bound_violations += episode.bound_violations;
    all.unfinished += episode.ended ? 0 : 1;
  }
  return all;
}

}  // namespace pomdp_crowd_nav
