// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

#include "pomdp_crowd_nav/despot/noise_streams.h"

namespace pomdp_crowd_nav {

// The part of a problem that takes its course whatever is done: one value for every scenario and
// depth. Drawn once per search, so that a step reads what it would else simulate again and again.
template <class Value>
class ExogenousTable {
  static_assert(!std::is_same_v<Value, bool>, "use char: rows of bits cannot be shared");

 public:
  // `first(scenario, noise)` is the value at depth 0, `next(value, scenario, depth, noise)` the one
  // that follows it; `depth` is that of the new value. Reuses memory.
  template <class First, class Next>
  void draw(int scenarios, int depth, const NoiseStreams& noise, First first, Next next) {
    depths_ = depth + 1;
    values_.resize(static_cast<size_t>(scenarios) * depths_);
    for (int k = 0; k < scenarios; ++k) {
      Value* row = values_.data() + static_cast<size_t>(k) * depths_;
      row[0] = first(k, noise);
      for (int d = 1; d <= depth; ++d) row[d] = next(row[d - 1], k, d, noise);
    }
  }

  const Value& at(int scenario, int depth) const {
    return values_[static_cast<size_t>(scenario) * depths_ + depth];
  }

 private:
  int depths_ = 0;
  std::vector<Value> values_;
};

// Whether a model wants to draw such tables at the start of a search.
template <class Model, class = void>
struct HasExogenous : std::false_type {};
template <class Model>
struct HasExogenous<Model, std::void_t<decltype(std::declval<Model&>().drawExogenous(0, 0))>>
    : std::true_type {};

}  // namespace pomdp_crowd_nav
