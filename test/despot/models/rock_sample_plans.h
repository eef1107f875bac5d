// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "rock_sample_map.h"

namespace pomdp_crowd_nav {

// What the best plan earns from every cell with every set of rocks to fetch, all of them good: the
// optimum of the problem without its uncertainty. Computed once, shared by all searches.
class RockSamplePlans {
 public:
  using Action = RockSampleAction;
  static constexpr float kRock = 10.0F;  // good; a bad one costs as much
  static constexpr float kExit = 10.0F;

  explicit RockSamplePlans(const RockSampleMap& map) : map_(map) {
    const int sets = 1 << map.rockCount();
    plans_.resize(static_cast<size_t>(map.cellCount()) * sets);
    for (int wanted = 0; wanted < sets; ++wanted) planFor(wanted);
  }

  const RockSampleMap& map() const { return map_; }

  // Discounted return of the best plan when the rocks of `wanted`, and no others, are good.
  float value(int cell, int wanted) const { return plan(cell, wanted).value; }
  int action(int cell, int wanted) const { return plan(cell, wanted).action; }

  // Discounted return of the same plan when in truth those of `good` are.
  float valueIf(int cell, int wanted, int good) const {
    const Plan& p = plan(cell, wanted);
    float sum = p.exit;
    for (int r = 0; r < RockSampleMap::kMostRocks; ++r) {
      sum += (good >> r & 1) != 0 ? p.rocks[r] : -p.rocks[r];
    }
    return sum;
  }

 private:
  struct Plan {
    float value = 0.0F;
    float exit = 0.0F;                                        // discounted reward of leaving
    std::array<float, RockSampleMap::kMostRocks> rocks = {};  // of each rock, 0 if left alone
    int action = Action::kEast;
  };

  const Plan& plan(int cell, int wanted) const {
    return plans_[static_cast<size_t>(wanted) * map_.cellCount() + cell];
  }
  Plan& plan(int cell, int wanted) {
    return plans_[static_cast<size_t>(wanted) * map_.cellCount() + cell];
  }

  // Value iteration; sets with fewer rocks are done. A sweep without a change ends it.
  void planFor(int wanted) {
    for (bool changed = true; changed;) {
      changed = false;
      for (int cell = 0; cell < map_.cellCount(); ++cell) {
        for (int action = Action::kNorth; action <= Action::kSample; ++action) {
          const Plan candidate = planAfter(cell, wanted, action);
          if (candidate.value <= plan(cell, wanted).value) continue;
          plan(cell, wanted) = candidate;
          changed = true;
        }
      }
    }
  }

  Plan planAfter(int cell, int wanted, int action) const {
    Plan result;
    result.action = action;
    int next = cell;
    int left = wanted;
    if (action == Action::kSample) {
      const int rock = map_.rockAt(cell);
      if (rock < 0 || (wanted >> rock & 1) == 0) return result;
      result.rocks[rock] = kRock;
      result.value = kRock;
      left = wanted & ~(1 << rock);
    } else {
      next = map_.moved(cell, action);
    }
    if (next < 0) {
      result.value = result.exit = kExit;
      return result;
    }
    const auto discount = static_cast<float>(map_.discount);
    const Plan& rest = plan(next, left);
    result.value += discount * rest.value;
    result.exit = discount * rest.exit;
    for (int r = 0; r < map_.rockCount(); ++r) result.rocks[r] += discount * rest.rocks[r];
    return result;
  }

  RockSampleMap map_;
  std::vector<Plan> plans_;
};

}  // namespace pomdp_crowd_nav
