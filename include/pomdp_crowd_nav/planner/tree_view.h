// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "pomdp_crowd_nav/despot/tree.h"
#include "pomdp_crowd_nav/planner/planner.h"

namespace pomdp_crowd_nav {

// The edges of a search tree whose beliefs share a state; `positionOf(state)` is the robot's.
template <class State, class Action, class PositionOf>
TreeView viewOf(const Tree<State, Action>& tree, const SearchParams& params,
                const TreeLimits& limits, PositionOf positionOf) {
  TreeView view;
  for (const ActionNode& node : tree.action_nodes) {
    if (node.child_count == 0) continue;
    const BeliefNode& child = tree.beliefs[node.first_child];
    if (child.depth > limits.depth) continue;
    const BeliefNode& parent = tree.beliefs[node.parent];
    TreeEdge edge;
    float lower = 0.0F;
    int count = 0;
    for (int c = node.first_child; c < node.first_child + node.child_count; ++c) {
      lower += tree.beliefs[c].lower;
      count += tree.beliefs[c].scenario_count;
    }
    edge.from = positionOf(tree.states[parent.first_state]);
    edge.to = positionOf(tree.states[child.first_state]);
    edge.weight = static_cast<float>(count) / static_cast<float>(params.scenarios);
    edge.depth = child.depth;
    edge.value = lower / edge.weight / static_cast<float>(std::pow(params.discount, edge.depth));
    view.edges.push_back(edge);
  }
  // A parent weighs at least as much as its child and comes first, so the cut leaves one tree.
  std::stable_sort(view.edges.begin(), view.edges.end(),
                   [](const TreeEdge& a, const TreeEdge& b) { return a.weight > b.weight; });
  if (static_cast<int>(view.edges.size()) > limits.edges) {
    view.edges.resize(std::max(0, limits.edges));
  }
  return view;
}

}  // namespace pomdp_crowd_nav
