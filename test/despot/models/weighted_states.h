// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

namespace pomdp_crowd_nav {

// A state and its probability.
template <class State>
struct WeightedState {
  State state;
  double weight = 0.0;
};

// Start states in proportion to their weights, which sum to 1: one at every `count`-th part of the
// distribution, the first at `offset` in [0, 1) of a part (systematic sampling).
template <class State>
std::vector<State> drawStates(const std::vector<WeightedState<State>>& from, int count,
                              double offset) {
  std::vector<State> drawn;
  size_t i = 0;
  double passed = from[0].weight;
  for (int k = 0; k < count; ++k) {
    while (passed <= (k + offset) / count && i + 1 < from.size()) passed += from[++i].weight;
    while (from[i].weight <= 0.0 && i > 0) --i;  // rounding led to a tail of impossible states
    drawn.push_back(from[i].state);
  }
  return drawn;
}

}  // namespace pomdp_crowd_nav
