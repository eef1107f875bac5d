// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

#include "tiger.h"
#include "weighted_states.h"

namespace pomdp_crowd_nav {

// The exact belief of the tiger problem: the probability that the tiger is on the left.
class TigerBelief {
 public:
  using Model = Tiger;

  explicit TigerBelief(const Tiger&) {}

  double left() const { return left_; }

  std::vector<WeightedState<Tiger::State>> states() const {
    return {{Tiger::kTigerLeft, left_}, {Tiger::kTigerRight, 1.0 - left_}};
  }

  void update(const Tiger&, Tiger::Action action, std::uint64_t observation) {
    if (action != Tiger::kListen) return;
    const double if_left = observation == 0 ? Tiger::kHearsRight : 1.0 - Tiger::kHearsRight;
    left_ = left_ * if_left / (left_ * if_left + (1.0 - left_) * (1.0 - if_left));
  }

 private:
  double left_ = 0.5;
};

// What the best policy without a horizon expects, by value iteration over the difference between
// what was heard on the left and on the right, which is all that matters.
inline double tigerOptimum(double discount) {
  constexpr int kMostHeard = 30;
  std::array<double, 2 * kMostHeard + 1> values{};
  const double odds = Tiger::kHearsRight / (1.0 - Tiger::kHearsRight);
  for (int sweep = 0; sweep < 2000; ++sweep) {
    const auto before = values;
    for (int i = 1; i < 2 * kMostHeard; ++i) {
      const double left = 1.0 / (1.0 + std::pow(odds, kMostHeard - i));
      const double surer = std::max(left, 1.0 - left);
      const double opens = surer * Tiger::kTreasure + (1.0 - surer) * Tiger::kMauled;
      const double hears = left * Tiger::kHearsRight + (1.0 - left) * (1.0 - Tiger::kHearsRight);
      const double listens =
          Tiger::kListening + discount * (hears * before[i + 1] + (1.0 - hears) * before[i - 1]);
      values[i] = std::max(opens, listens);
    }
  }
  return values[kMostHeard];
}

}  // namespace pomdp_crowd_nav
