// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <utility>
#include <vector>

#include "pomdp_crowd_nav/despot/expansion.h"
#include "pomdp_crowd_nav/despot/search_result.h"
#include "pomdp_crowd_nav/despot/tree_values.h"

namespace pomdp_crowd_nav {

// Puts expansions into the tree: an action node for every action, and a belief below it for every
// observation. Refers to the tree and its values, which must outlive it.
template <class Model>
class TreeGrowth {
 public:
  using ModelTree = Tree<typename Model::State, typename Model::Action>;

  TreeGrowth(ModelTree& tree, TreeValues& values, const SearchParams& params)
      : tree_(tree), values_(values) {
    for (int d = 0; d <= params.max_depth + 1; ++d) {
      weights_.push_back(static_cast<float>(std::pow(params.discount, d) / params.scenarios));
    }
    regularization_ = static_cast<float>(params.regularization);
  }

  void addActions(int belief, const Expansion<Model>& expansion, SearchStatistics& statistics) {
    assert(!expansion.actions.empty());
    const BeliefNode node = tree_.beliefs[belief];
    const int first_action = static_cast<int>(tree_.action_nodes.size());
    const int action_count = static_cast<int>(expansion.actions.size());
    const size_t first_belief = tree_.beliefs.size();
    for (int a = 0; a < action_count; ++a) addAction(belief, node, expansion, a, statistics);
    tree_.beliefs[belief].first_action = first_action;
    tree_.beliefs[belief].action_count = static_cast<std::uint16_t>(action_count);
    ++statistics.expansions;
    statistics.model_steps += expansion.model_steps;
    statistics.belief_nodes += static_cast<long>(tree_.beliefs.size() - first_belief);
  }

 private:
  void addAction(int belief, const BeliefNode& node, const Expansion<Model>& expansion, int a,
                 SearchStatistics& statistics) {
    const Branch* branches = &expansion.branches[static_cast<size_t>(a) * node.scenario_count];
    ActionNode action;
    action.parent = belief;
    action.first_child = static_cast<std::int32_t>(tree_.beliefs.size());
    action.reward = weights_[node.depth] * groupByObservation(branches, node) - regularization_;
    const int action_index = static_cast<int>(tree_.action_nodes.size());
    addChildren(node, expansion, a, action_index, statistics);
    action.child_count = static_cast<std::int32_t>(tree_.beliefs.size()) - action.first_child;
    tree_.action_nodes.push_back(action);
    tree_.actions.push_back(expansion.actions[a]);
    values_.sumChildren(action_index);
  }

  // Leaves the living scenarios in `order_`, those with equal observations side by side. Returns
  // the sum of all rewards.
  float groupByObservation(const Branch* branches, const BeliefNode& node) {
    float reward = 0.0F;
    order_.clear();
    for (int i = 0; i < node.scenario_count; ++i) {
      reward += branches[i].reward;
      if (!branches[i].terminal) order_.push_back(i);
    }
    const auto comes_first = [branches](int i, int j) {
      const auto& p = branches[i].observation;
      const auto& q = branches[j].observation;
      return p != q ? p < q : i < j;  // the index makes it stable without a buffer
    };
    if (!std::is_sorted(order_.begin(), order_.end(), comes_first)) {
      std::sort(order_.begin(), order_.end(), comes_first);
    }
    return reward;
  }

  void addChildren(const BeliefNode& node, const Expansion<Model>& expansion, int a,
                   int action_index, SearchStatistics& statistics) {
    const size_t first_branch = static_cast<size_t>(a) * node.scenario_count;
    const Branch* branches = &expansion.branches[first_branch];
    const int shared_state = static_cast<int>(tree_.states.size());
    if (Model::kSharesState && !order_.empty()) tree_.states.push_back(expansion.states[a]);
    for (size_t begin = 0, end = 0; begin < order_.size(); begin = end) {
      BeliefNode child;
      child.parent = action_index;
      child.depth = static_cast<std::uint16_t>(node.depth + 1);
      child.first_scenario = static_cast<std::int32_t>(tree_.scenarios.size());
      child.first_state =
          Model::kSharesState ? shared_state : static_cast<int>(tree_.states.size());
      const std::uint64_t observation = branches[order_[begin]].observation;
      std::array<float, kDefaultPolicies> lower{};
      float upper = 0.0F;
      for (; end < order_.size() && branches[order_[end]].observation == observation; ++end) {
        const int i = order_[end];
        for (int p = 0; p < kDefaultPolicies; ++p) lower[p] += branches[i].lower[p];
        upper += branches[i].upper;
        tree_.scenarios.push_back(tree_.scenarios[node.first_scenario + i]);
        if (!Model::kSharesState) tree_.states.push_back(expansion.states[first_branch + i]);
      }
      child.scenario_count = static_cast<std::uint16_t>(end - begin);
      const float weight = weights_[child.depth];
      // One policy for the whole belief: its scenarios cannot be told apart.
      const float best = *std::max_element(lower.begin(), lower.end());
      const bool is_valid = values_.setInitialBounds(
          child, weight * best, weight * upper, weight * static_cast<float>(child.scenario_count));
      if (!is_valid) ++statistics.bound_violations;
      tree_.beliefs.push_back(child);
    }
  }

  ModelTree& tree_;
  TreeValues& values_;
  std::vector<float> weights_;  // discount^depth / scenarios
  float regularization_ = 0.0F;
  std::vector<int> order_;
};

}  // namespace pomdp_crowd_nav
