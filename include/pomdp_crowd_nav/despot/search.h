// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "pomdp_crowd_nav/despot/expansion.h"
#include "pomdp_crowd_nav/despot/search_params.h"
#include "pomdp_crowd_nav/despot/search_result.h"
#include "pomdp_crowd_nav/despot/tree.h"

namespace pomdp_crowd_nav {

// Regularised DESPOT (Ye et al. 2017), anytime: trials refine the tree until the limit.
//
// A Model has
//   types   State, Action
//   static constexpr bool kSharesState   all scenarios of a belief are in one state
//   void expand(const State* states, const int* scenarios, int count, int depth,
//               Expansion<Model>&) const
//   void rootBounds(const State* states, const int* scenarios, int count, double& lower,
//                   double& upper) const        means over the scenarios
//   Action defaultAction(const State*) const    a legal action of the default policy
// Everything random comes from noise addressed by (scenario, depth): same seed, same tree.
//
// One search object serves many searches and keeps its memory. Not thread-safe.
template <class Model>
class Search {
 public:
  using State = typename Model::State;
  using Action = typename Model::Action;

  explicit Search(const SearchParams& params) : params_(params) {
    validate(params);
    tree_.reserve(static_cast<size_t>(params.max_nodes) + params.scenarios);
    for (int d = 0; d <= params.max_depth + 1; ++d) {
      weights_.push_back(static_cast<float>(std::pow(params.discount, d) / params.scenarios));
    }
  }

  // `states`: one state where the model shares it, else one per scenario.
  SearchResult<Action> run(const Model& model, std::vector<State> states,
                           const SearchLimit& limit) {
    plantRoot(model, std::move(states));
    // Even a closed root is expanded: which action attains its bounds is not known before.
    if (params_.max_depth > 0) {
      expand(model, 0);
      backUp(0);
    }
    statistics_.stop = runTrials(model, limit);
    return collectResult(model);
  }

  const Tree<State, Action>& tree() const { return tree_; }
  const SearchParams& params() const { return params_; }

 private:
  void plantRoot(const Model& model, std::vector<State> states) {
    tree_.clear();
    statistics_ = {};
    tree_.states = std::move(states);
    for (int k = 0; k < params_.scenarios; ++k) tree_.scenarios.push_back(k);
    double lower = 0.0;
    double upper = 0.0;
    model.rootBounds(tree_.states.data(), tree_.scenarios.data(), params_.scenarios, lower, upper);
    BeliefNode root;
    root.scenario_count = static_cast<std::uint16_t>(params_.scenarios);
    setInitialBounds(root, static_cast<float>(lower), static_cast<float>(upper), 1.0F);
    tree_.beliefs.push_back(root);
    statistics_.initial_lower_bound = root.lower;
    statistics_.initial_upper_bound = root.upper;
  }

  SearchStop runTrials(const Model& model, const SearchLimit& limit) {
    using Clock = SearchLimit::Clock;
    const bool timed = limit.deadline != Clock::time_point::max();
    Clock::time_point now = timed ? Clock::now() : Clock::time_point();
    Clock::duration longest_trial{0};
    while (true) {
      if (rootGap() <= 0.0F) return SearchStop::kGapClosed;
      if (tree_.beliefs[0].lower >= limit.lower_bound) return SearchStop::kLowerBound;
      if (statistics_.trials >= limit.max_trials) return SearchStop::kTrialLimit;
      if (timed && now + longest_trial >= limit.deadline) return SearchStop::kDeadline;
      if (!explore(model)) return SearchStop::kNodeLimit;
      ++statistics_.trials;
      if (!timed) continue;
      const Clock::time_point then = Clock::now();
      longest_trial = std::max(longest_trial, then - now);
      now = then;
    }
  }

  // One trial: descends along the most promising action and the least certain observation.
  // Returns false when the tree is full.
  bool explore(const Model& model) {
    int belief = 0;
    bool has_room = true;
    float allowance = std::numeric_limits<float>::max();
    while (true) {
      if (tree_.beliefs[belief].depth >= params_.max_depth || allowance <= 0.0F) {
        makeDefault(belief);
        break;
      }
      if (excessUncertainty(tree_.beliefs[belief]) <= 0.0F) break;
      if (tree_.beliefs[belief].isLeaf()) {
        has_room = static_cast<int>(tree_.beliefs.size()) < params_.max_nodes;
        if (!has_room) break;
        expand(model, belief);
      }
      const int child = leastCertainChild(mostPromisingAction(belief));
      if (child < 0) break;
      allowance = allowanceBelow(tree_.beliefs[belief], allowance);
      belief = child;
    }
    backUp(belief);
    return has_room;
  }

  void expand(const Model& model, int belief) {
    const BeliefNode node = tree_.beliefs[belief];
    model.expand(&tree_.states[node.first_state], &tree_.scenarios[node.first_scenario],
                 node.scenario_count, node.depth, expansion_);
    ++statistics_.expansions;
    statistics_.model_steps += expansion_.model_steps;
    const int first_action = static_cast<int>(tree_.action_nodes.size());
    const int action_count = static_cast<int>(expansion_.actions.size());
    for (int a = 0; a < action_count; ++a) addAction(belief, node, a);
    tree_.beliefs[belief].first_action = first_action;
    tree_.beliefs[belief].action_count = static_cast<std::uint16_t>(action_count);
  }

  void addAction(int belief, const BeliefNode& node, int a) {
    const Branch* branches = &expansion_.branches[static_cast<size_t>(a) * node.scenario_count];
    ActionNode action;
    action.parent = belief;
    action.first_child = static_cast<std::int32_t>(tree_.beliefs.size());
    float reward = 0.0F;
    order_.clear();
    for (int i = 0; i < node.scenario_count; ++i) {
      reward += branches[i].reward;
      if (!branches[i].terminal) order_.push_back(i);
    }
    action.reward = weights_[node.depth] * reward - regularization();
    if (order_.size() > 1) {
      std::stable_sort(order_.begin(), order_.end(), [branches](int i, int j) {
        return branches[i].observation < branches[j].observation;
      });
    }
    const int action_index = static_cast<int>(tree_.action_nodes.size());
    addChildren(node, a, branches, action_index);
    action.child_count = static_cast<std::int32_t>(tree_.beliefs.size()) - action.first_child;
    tree_.action_nodes.push_back(action);
    tree_.actions.push_back(expansion_.actions[a]);
    sumChildren(action_index);
  }

  // One child per observation; `order_` holds the live scenarios grouped by observation.
  void addChildren(const BeliefNode& node, int a, const Branch* branches, int action_index) {
    const int shared_state = static_cast<int>(tree_.states.size());
    if (Model::kSharesState && !order_.empty()) tree_.states.push_back(expansion_.states[a]);
    const size_t first_branch = static_cast<size_t>(a) * node.scenario_count;
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
        if (!Model::kSharesState) tree_.states.push_back(expansion_.states[first_branch + i]);
      }
      child.scenario_count = static_cast<std::uint16_t>(end - begin);
      const float weight = weights_[child.depth];
      // One policy for the whole belief: its scenarios cannot be told apart.
      const float best = *std::max_element(lower.begin(), lower.end());
      setInitialBounds(child, weight * best, weight * upper,
                       weight * static_cast<float>(child.scenario_count));
      tree_.beliefs.push_back(child);
      ++statistics_.belief_nodes;
    }
  }

  // `weight`: of a return of 1 in all of the node's scenarios.
  void setInitialBounds(BeliefNode& node, float lower, float upper, float weight) {
    if (lower > upper + 1e-4F * (weight + std::abs(upper))) ++statistics_.bound_violations;
    node.default_value = lower;
    node.lower = lower;
    node.utility_upper = std::max(lower, upper);
    node.upper = std::max(lower, node.utility_upper - regularization());
  }

  // The node's best policy is its default one: nothing below it can pay for itself.
  void makeDefault(int belief) {
    BeliefNode& node = tree_.beliefs[belief];
    node.blocked = true;
    node.upper = node.lower;
  }

  // What the regularisation may still cost on the way down before it outweighs the whole gain of
  // some node above; at 0 or less that node is a blocker (Ye et al. 2017, eq. 16, FindBlocker).
  float allowanceBelow(const BeliefNode& node, float allowance) const {
    return std::min(allowance, node.utility_upper - node.default_value) - regularization();
  }

  // E(b), weighted excess uncertainty (Ye et al. 2017, eq. 12).
  float excessUncertainty(const BeliefNode& node) const {
    const float share = static_cast<float>(node.scenario_count) / params_.scenarios;
    return node.upper - node.lower - share * static_cast<float>(params_.target_gap) * rootGap();
  }

  int mostPromisingAction(int belief) const {
    const BeliefNode& node = tree_.beliefs[belief];
    int best = node.first_action;
    for (int a = best + 1; a < node.first_action + node.action_count; ++a) {
      if (tree_.action_nodes[a].upper > tree_.action_nodes[best].upper) best = a;
    }
    return best;
  }

  // -1 when the action ends every scenario.
  int leastCertainChild(int action) const {
    const ActionNode& node = tree_.action_nodes[action];
    int best = -1;
    float best_excess = 0.0F;
    for (int c = node.first_child; c < node.first_child + node.child_count; ++c) {
      const float excess = excessUncertainty(tree_.beliefs[c]);
      if (best >= 0 && excess <= best_excess) continue;
      best = c;
      best_excess = excess;
    }
    return best;
  }

  // Recomputes every value from `belief` to the root. Bounds only ever move inward: both the old
  // and the new value are valid.
  void backUp(int belief) {
    if (!tree_.beliefs[belief].isLeaf()) refine(tree_.beliefs[belief]);
    for (int action = tree_.beliefs[belief].parent; action >= 0;) {
      sumChildren(action);
      BeliefNode& parent = tree_.beliefs[tree_.action_nodes[action].parent];
      refine(parent);
      action = parent.parent;
    }
  }

  void sumChildren(int action) {
    ActionNode& node = tree_.action_nodes[action];
    node.lower = node.reward;
    node.upper = node.reward;
    node.utility_upper = node.reward + regularization();
    for (int c = node.first_child; c < node.first_child + node.child_count; ++c) {
      node.lower += tree_.beliefs[c].lower;
      node.upper += tree_.beliefs[c].upper;
      node.utility_upper += tree_.beliefs[c].utility_upper;
    }
  }

  void refine(BeliefNode& node) const {
    float lower = node.default_value;
    float upper = node.default_value;
    float utility = node.default_value;
    for (int a = node.first_action; a < node.first_action + node.action_count; ++a) {
      lower = std::max(lower, tree_.action_nodes[a].lower);
      upper = std::max(upper, tree_.action_nodes[a].upper);
      utility = std::max(utility, tree_.action_nodes[a].utility_upper);
    }
    node.lower = std::max(node.lower, lower);
    node.utility_upper = std::max(node.default_value, std::min(node.utility_upper, utility));
    if (!node.blocked) node.upper = std::max(node.lower, std::min(node.upper, upper));
  }

  // Highest lower bound among the node's actions, first on ties.
  int bestAction(int belief) const {
    const BeliefNode& node = tree_.beliefs[belief];
    int best = node.first_action;
    for (int a = best + 1; a < node.first_action + node.action_count; ++a) {
      if (tree_.action_nodes[a].lower > tree_.action_nodes[best].lower) best = a;
    }
    return best;
  }

  int likeliestChild(int action) const {
    const ActionNode& node = tree_.action_nodes[action];
    int best = -1;
    for (int c = node.first_child; c < node.first_child + node.child_count; ++c) {
      if (best < 0 || tree_.beliefs[c].scenario_count > tree_.beliefs[best].scenario_count) {
        best = c;
      }
    }
    return best;
  }

  SearchResult<Action> collectResult(const Model& model) {
    const BeliefNode& root = tree_.beliefs[0];
    statistics_.lower_bound = root.lower;
    statistics_.upper_bound = root.upper;
    SearchResult<Action> result{model.defaultAction(tree_.states.data()), true, {}, statistics_};
    for (int belief = 0; belief >= 0 && !tree_.beliefs[belief].isLeaf();) {
      const int action = bestAction(belief);
      result.plan.push_back(tree_.actions[action]);
      belief = likeliestChild(action);
    }
    if (result.plan.empty()) {
      result.plan.push_back(result.action);
    } else {
      result.action = result.plan.front();
      result.from_default = false;
    }
    return result;
  }

  float rootGap() const { return tree_.beliefs[0].upper - tree_.beliefs[0].lower; }
  float regularization() const { return static_cast<float>(params_.regularization); }

  SearchParams params_;
  std::vector<float> weights_;  // discount^depth / scenarios
  Tree<State, Action> tree_;
  Expansion<Model> expansion_;
  std::vector<int> order_;
  SearchStatistics statistics_;
};

}  // namespace pomdp_crowd_nav
