// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "pomdp_crowd_nav/despot/search_params.h"
#include "pomdp_crowd_nav/despot/tree.h"

namespace pomdp_crowd_nav {

// The bounds of a tree's nodes, and the choices that follow from them (Ye et al. 2017, section 4).
// Refers to the tree's nodes, which must outlive it.
class TreeValues {
 public:
  TreeValues(TreeNodes& tree, const SearchParams& params)
      : tree_(tree),
        regularization_(static_cast<float>(params.regularization)),
        target_gap_(static_cast<float>(params.target_gap)),
        scenarios_(static_cast<float>(params.scenarios)),
        has_visitors_(params.threads > 1) {}

  // Bounds of a new node, all weighted; `weight` is that of a return of 1 in all its scenarios.
  // Returns false, and clamps, if the lower bound is above the upper.
  bool setInitialBounds(BeliefNode& node, float lower, float upper, float weight) const {
    node.default_value = lower;
    node.lower = lower;
    node.utility_upper = std::max(lower, upper);
    node.upper = std::max(lower, node.utility_upper - regularization_);
    return lower <= upper + 1e-4F * (weight + std::abs(upper));
  }

  // The node's best policy is its default one: nothing below it can pay for itself. Returns
  // whether its bounds differed.
  bool makeDefault(int belief) {
    BeliefNode& node = tree_.beliefs[belief];
    const bool differed = node.upper > node.lower;
    node.blocked = true;
    node.upper = node.lower;
    return differed;
  }

  // What the regularisation may still cost on the way down before it outweighs the whole gain of
  // some node above; at 0 or less that node is a blocker (eq. 16, FindBlocker).
  float allowanceBelow(int belief, float allowance) const {
    const BeliefNode& node = tree_.beliefs[belief];
    return std::min(allowance, node.utility_upper - node.default_value) - regularization_;
  }

  float rootGap() const { return tree_.beliefs[0].upper - tree_.beliefs[0].lower; }

  // E(b), weighted excess uncertainty (eq. 12).
  float excessUncertainty(int belief) const {
    const BeliefNode& node = tree_.beliefs[belief];
    return node.upper - node.lower - targetGap(node);
  }

  // Highest upper bound. Where several threads are at work, an action whose only belief is being
  // visited counts as if the visitors would close their share of its gap from above.
  int mostPromisingAction(int belief) const {
    const BeliefNode& node = tree_.beliefs[belief];
    int best = node.first_action;
    float best_upper = promise(best);
    for (int a = best + 1; a < node.first_action + node.action_count; ++a) {
      const float upper = promise(a);
      if (upper <= best_upper) continue;
      best = a;
      best_upper = upper;
    }
    return best;
  }

  // The child of most excess uncertainty, where the gap of one that other threads are at work in
  // counts as shared among all visitors. -1 when the action ends every scenario.
  int leastCertainChild(int action) const {
    const ActionNode& node = tree_.action_nodes[action];
    if (node.child_count == 1) return node.first_child;
    int best = -1;
    float best_excess = 0.0F;
    for (int c = node.first_child; c < node.first_child + node.child_count; ++c) {
      const BeliefNode& child = tree_.beliefs[c];
      const float gap = (child.upper - child.lower) / static_cast<float>(1 + child.visitors);
      const float excess = gap - targetGap(child);
      if (best >= 0 && excess <= best_excess) continue;
      best = c;
      best_excess = excess;
    }
    return best;
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

  // Recomputes every value from `belief` to the root. Bounds only ever move inward: both the old
  // and the new value are valid. Returns at how many nodes they were found not to be.
  int backUp(int belief) {
    int violations = 0;
    if (!tree_.beliefs[belief].isLeaf()) violations += refine(tree_.beliefs[belief]) ? 0 : 1;
    for (int action = tree_.beliefs[belief].parent; action >= 0;) {
      sumChildren(action);
      BeliefNode& parent = tree_.beliefs[tree_.action_nodes[action].parent];
      violations += refine(parent) ? 0 : 1;
      action = parent.parent;
    }
    return violations;
  }

  void sumChildren(int action) {
    ActionNode& node = tree_.action_nodes[action];
    node.lower = node.reward;
    node.upper = node.reward;
    node.utility_upper = node.reward + regularization_;
    for (int c = node.first_child; c < node.first_child + node.child_count; ++c) {
      node.lower += tree_.beliefs[c].lower;
      node.upper += tree_.beliefs[c].upper;
      node.utility_upper += tree_.beliefs[c].utility_upper;
    }
  }

 private:
  float promise(int action) const {
    const ActionNode& node = tree_.action_nodes[action];
    if (!has_visitors_ || node.child_count != 1) return node.upper;
    const BeliefNode& child = tree_.beliefs[node.first_child];
    const auto visitors = static_cast<float>(child.visitors);
    return node.upper - (child.upper - child.lower) * visitors / (1.0F + visitors);
  }

  // Returns false, and gives up the upper bound, if the lower one has risen above it.
  bool refine(BeliefNode& node) const {
    float lower = node.default_value;
    float upper = node.default_value;
    float utility = node.default_value;
    for (int a = node.first_action; a < node.first_action + node.action_count; ++a) {
      lower = std::max(lower, tree_.action_nodes[a].lower);
      upper = std::max(upper, tree_.action_nodes[a].upper);
      utility = std::max(utility, tree_.action_nodes[a].utility_upper);
    }
    const float rounding = 1e-4F * (std::abs(lower) + std::abs(node.utility_upper)) + 1e-6F;
    const bool is_valid = lower <= node.utility_upper + rounding;
    node.lower = std::max(node.lower, lower);
    node.utility_upper = std::max(node.lower, std::min(node.utility_upper, utility));
    node.upper = node.blocked ? node.lower : std::max(node.lower, std::min(node.upper, upper));
    return is_valid;
  }

  // The part of the root's gap that may remain in a node (Ye et al. 2017, section 4.2).
  float targetGap(const BeliefNode& node) const {
    return static_cast<float>(node.scenario_count) / scenarios_ * target_gap_ * rootGap();
  }

  TreeNodes& tree_;
  float regularization_;  // lambda
  float target_gap_;      // xi
  float scenarios_;       // K
  bool has_visitors_;     // of other threads
};

}  // namespace pomdp_crowd_nav
