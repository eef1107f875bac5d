// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <vector>

#include "pomdp_crowd_nav/despot/expansion.h"
#include "pomdp_crowd_nav/despot/search_params.h"

namespace pomdp_crowd_nav {

// The regularised optimum over all policies for a set of scenarios, found by trying every action
// in every history (Ye et al. 2017, eq. 9): mean discounted return less lambda per policy node. A
// policy may hand over to a default one anywhere, and has to at the horizon.
template <class Model>
class EveryPolicy {
 public:
  using State = typename Model::State;
  using Action = typename Model::Action;

  EveryPolicy(const Model& model, const SearchParams& params) : model_(model), params_(params) {}

  double optimum(const std::vector<State>& states) const {
    double upper = 0.0;
    Belief root{states, std::vector<int>(params_.scenarios)};
    std::iota(root.scenarios.begin(), root.scenarios.end(), 0);
    double default_value = 0.0;
    model_.rootBounds(states.data(), root.scenarios.data(), params_.scenarios, default_value,
                      upper);
    root.default_value = default_value;
    return value(root, 0);
  }

  // Of taking `action` at the root and going on as well as possible.
  double valueOf(const Action& action, const std::vector<State>& states) const {
    Belief root{states, std::vector<int>(params_.scenarios)};
    std::iota(root.scenarios.begin(), root.scenarios.end(), 0);
    return actionValue(root, 0, action);
  }

 private:
  struct Belief {
    std::vector<State> states;  // one where the model shares it
    std::vector<int> scenarios;
    double default_value = 0.0;  // share of the root's, discounted
    std::vector<double> defaults = std::vector<double>(kDefaultPolicies, 0.0);
  };

  double value(const Belief& belief, int depth) const {
    double best = belief.default_value;
    if (depth == params_.max_depth) return best;
    std::vector<Action> actions;
    model_.actions(belief.states[0], actions);
    for (const Action& action : actions) {
      best = std::max(best, actionValue(belief, depth, action));
    }
    return best;
  }

  double actionValue(const Belief& belief, int depth, const Action& action) const {
    const double weight = std::pow(params_.discount, depth) / params_.scenarios;
    double sum = -params_.regularization;
    std::map<std::uint64_t, Belief> children;
    for (size_t i = 0; i < belief.scenarios.size(); ++i) {
      const State& state = belief.states[Model::kSharesState ? 0 : i];
      State next = state;
      Branch branch = model_.step(state, belief.scenarios[i], depth, action, next);
      sum += weight * branch.reward;
      if (branch.terminal) continue;
      model_.bound(next, belief.scenarios[i], depth + 1, branch);
      Belief& child = children[branch.observation];
      if (!Model::kSharesState || child.states.empty()) child.states.push_back(next);
      child.scenarios.push_back(belief.scenarios[i]);
      for (int p = 0; p < kDefaultPolicies; ++p) {
        child.defaults[p] += weight * params_.discount * static_cast<double>(branch.lower[p]);
      }
    }
    for (auto& entry : children) {
      Belief& child = entry.second;
      child.default_value = *std::max_element(child.defaults.begin(), child.defaults.end());
      sum += value(child, depth + 1);
    }
    return sum;
  }

  const Model& model_;
  SearchParams params_;
};

}  // namespace pomdp_crowd_nav
