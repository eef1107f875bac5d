// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "pomdp_crowd_nav/despot/search_params.h"

namespace pomdp_crowd_nav {

// A belief: a set of scenarios with one history. All values are weighted by the node's share of
// scenarios and discounted to the root, so that values of siblings add up.
struct BeliefNode {
  static constexpr std::int32_t kIsLeaf = -1;
  static constexpr std::int32_t kIsBeingExpanded = -2;  // a leaf that some thread is at work on

  float lower = 0.0F;          // l, regularised lower bound
  float upper = 0.0F;          // mu, regularised upper bound
  float utility_upper = 0.0F;  // U, upper bound without regularisation, for the blocker test
  float default_value = 0.0F;  // l0, value of the default policy
  std::int32_t parent = -1;    // action node, -1 for the root
  std::int32_t first_action = kIsLeaf;
  std::int32_t first_scenario = 0;
  std::int32_t first_state = 0;
  std::uint16_t scenario_count = 0;
  std::uint16_t action_count = 0;
  std::uint16_t depth = 0;
  bool blocked = false;
  std::uint8_t visitors = 0;  // trials under way through this node

  bool isLeaf() const { return first_action < 0; }
  bool isBeingExpanded() const { return first_action == kIsBeingExpanded; }
};

// An action taken at a belief. `reward` is rho(b, a), lambda already taken off.
struct ActionNode {
  float reward = 0.0F;
  float lower = 0.0F;
  float upper = 0.0F;
  float utility_upper = 0.0F;
  std::int32_t parent = -1;
  std::int32_t first_child = 0;
  std::int32_t child_count = 0;  // children are consecutive
};

// The nodes of a search tree in flat vectors linked by index.
struct TreeNodes {
  std::vector<BeliefNode> beliefs;  // beliefs[0] is the root
  std::vector<ActionNode> action_nodes;

  int parentBelief(int belief) const {
    const int action = beliefs[belief].parent;
    return action < 0 ? -1 : action_nodes[action].parent;
  }
};

// And what a model put into them. `clear` keeps the memory for the next search.
template <class State, class Action>
struct Tree : TreeNodes {
  std::vector<Action> actions;  // parallel to action_nodes
  std::vector<std::int32_t> scenarios;
  std::vector<State> states;

  // Room for a tree of as many nodes as the parameters allow: a vector that moved while it grows
  // would hold up a search for longer than its margin. Pages that are never used cost nothing.
  void reserve(const SearchParams& params, bool shares_state) {
    const auto bytes = static_cast<std::size_t>(params.max_memory * 1e6);
    const auto nodes = static_cast<std::size_t>(params.max_nodes);
    const auto scenarios_each = static_cast<std::size_t>(shares_state ? 2 : params.scenarios);
    const auto room = [bytes](std::size_t count, std::size_t size) {
      return std::min(count, bytes / size) + 10000;  // and one large expansion more
    };
    beliefs.reserve(room(nodes, sizeof(BeliefNode)));
    action_nodes.reserve(room(4 * nodes, sizeof(ActionNode)));  // some have no belief below
    actions.reserve(room(4 * nodes, sizeof(ActionNode)));
    scenarios.reserve(room(scenarios_each * nodes, sizeof(std::int32_t)));
    states.reserve(room(scenarios_each * nodes, sizeof(State)));
  }

  std::size_t bytes() const {
    return beliefs.size() * sizeof(BeliefNode) + action_nodes.size() * sizeof(ActionNode) +
           actions.size() * sizeof(Action) + scenarios.size() * sizeof(std::int32_t) +
           states.size() * sizeof(State);
  }

  void clear() {
    beliefs.clear();
    action_nodes.clear();
    actions.clear();
    scenarios.clear();
    states.clear();
  }
};

}  // namespace pomdp_crowd_nav
