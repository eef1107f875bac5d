// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pomdp_crowd_nav {

// A belief: a set of scenarios with one history. All values are weighted by the node's share of
// scenarios and discounted to the root, so that values of siblings add up.
struct BeliefNode {
  float lower = 0.0F;              // l, regularised lower bound
  float upper = 0.0F;              // mu, regularised upper bound
  float utility_upper = 0.0F;      // U, upper bound without regularisation, for the blocker test
  float default_value = 0.0F;      // l0, value of the default policy
  std::int32_t parent = -1;        // action node, -1 for the root
  std::int32_t first_action = -1;  // -1 while the node is a leaf
  std::int32_t first_scenario = 0;
  std::int32_t first_state = 0;
  std::uint16_t scenario_count = 0;
  std::uint16_t action_count = 0;
  std::uint16_t depth = 0;
  bool blocked = false;

  bool isLeaf() const { return first_action < 0; }
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

// The search tree in flat vectors linked by index; `clear` keeps the memory for the next search.
template <class State, class Action>
struct Tree {
  std::vector<BeliefNode> beliefs;  // beliefs[0] is the root
  std::vector<ActionNode> action_nodes;
  std::vector<Action> actions;  // parallel to action_nodes
  std::vector<std::int32_t> scenarios;
  std::vector<State> states;

  // Room for a tree of `count` beliefs: a vector that moved while it grows would hold up a search
  // for longer than its margin. Pages that are never used cost nothing.
  void reserve(std::size_t count) {
    beliefs.reserve(count);
    action_nodes.reserve(count);
    actions.reserve(count);
    scenarios.reserve(count);
    states.reserve(count);
  }

  void clear() {
    beliefs.clear();
    action_nodes.clear();
    actions.clear();
    scenarios.clear();
    states.clear();
  }

  int parentBelief(int belief) const {
    const int action = beliefs[belief].parent;
    return action < 0 ? -1 : action_nodes[action].parent;
  }
};

}  // namespace pomdp_crowd_nav
