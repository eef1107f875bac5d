// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace pomdp_crowd_nav {

// How many default policies a model may value a belief with; the search takes the best of them.
constexpr int kDefaultPolicies = 2;

// What one action does in one scenario, and what the belief after it is worth.
struct Branch {
  float reward = 0.0F;
  bool terminal = false;          // the scenario ends: observation and bounds are not read
  std::uint64_t observation = 0;  // scenarios with equal keys stay in one belief
  // Discounted return from the next state of each default policy; lowest where there is none.
  std::array<float, kDefaultPolicies> lower{0.0F, std::numeric_limits<float>::lowest()};
  float upper = 0.0F;  // bound on the return of any policy from the next state
};

// Everything that a model says of one belief node at once, so that it can fill vector lanes with
// actions and scenarios. Reused between expansions: `reset` keeps the memory.
template <class Model>
struct Expansion {
  using State = typename Model::State;
  using Action = typename Model::Action;

  std::vector<Action> actions;   // legal at the node: at least one
  std::vector<Branch> branches;  // action by action: branches[a * scenario_count + i]
  // Next states: one per action where the model shares states, else parallel to branches.
  std::vector<State> states;
  long model_steps = 0;  // steps evaluated, roll-outs included

  void reset() {
    actions.clear();
    branches.clear();
    states.clear();
    model_steps = 0;
  }
};

// Fills an expansion from a model that thinks one scenario at a time, with
//   Action set:  void actions(const State&, std::vector<Action>&) const
//   Step:        Branch step(const State&, int scenario, int depth, const Action&, State& next)
//   Leaf value:  void bound(const State&, int scenario, int depth, Branch&)
template <class Model>
void expandOneByOne(const Model& model, const typename Model::State* states, const int* scenarios,
                    int scenario_count, int depth, Expansion<Model>& out) {
  out.reset();
  model.actions(states[0], out.actions);
  const size_t count = static_cast<size_t>(scenario_count);
  out.branches.resize(out.actions.size() * count);
  out.states.resize(out.actions.size() * (Model::kSharesState ? 1 : count));
  for (size_t a = 0; a < out.actions.size(); ++a) {
    for (size_t i = 0; i < count; ++i) {
      const auto& state = states[Model::kSharesState ? 0 : i];
      auto& next = out.states[Model::kSharesState ? a : a * count + i];
      next = state;
      Branch& branch = out.branches[a * count + i];
      branch = model.step(state, scenarios[i], depth, out.actions[a], next);
      if (!branch.terminal) model.bound(next, scenarios[i], depth + 1, branch);
    }
  }
  out.model_steps = static_cast<long>(out.branches.size());
}

// The bounds of a root likewise: of each policy the mean over the scenarios, then the best policy.
template <class Model>
void boundOneByOne(const Model& model, const typename Model::State* states, const int* scenarios,
                   int scenario_count, double& lower, double& upper) {
  std::array<double, kDefaultPolicies> lowers{};
  upper = 0.0;
  for (int i = 0; i < scenario_count; ++i) {
    Branch branch;
    model.bound(states[Model::kSharesState ? 0 : i], scenarios[i], 0, branch);
    for (int p = 0; p < kDefaultPolicies; ++p) lowers[p] += branch.lower[p] / scenario_count;
    upper += static_cast<double>(branch.upper) / scenario_count;
  }
  lower = *std::max_element(lowers.begin(), lowers.end());
}

}  // namespace pomdp_crowd_nav
