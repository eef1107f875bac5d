// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "rock_sample_map.h"

namespace pomdp_crowd_nav {

// A policy for RockSample: go to some of the rocks of a set, check each from its own cell, where
// the sensor never errs, sample it if it is good, and leave. Its way is the best one for rocks that
// are all as likely good as bad. Computed once, shared by all searches.
class RockSampleInspection {
 public:
  using Action = RockSampleAction;

  explicit RockSampleInspection(const RockSampleMap& map) : map_(map) {
    const int sets = 1 << map.rockCount();
    for (int set = 0; set < sets; ++set) {
      int index = 0;
      for (int r = map.rockCount() - 1; r >= 0; --r) index = 3 * index + (set >> r & 1);
      ternary_.push_back(index);
    }
    values_.assign(static_cast<size_t>(2 * ternary_.back() + 1) * map.cellCount() + map.cellCount(),
                   0.0F);
    actions_.resize(static_cast<size_t>(sets) * map.cellCount());
    for (int wanted = 0; wanted < sets; ++wanted) planFor(wanted);
  }

  int action(int cell, int wanted) const { return actions_[wanted * map_.cellCount() + cell]; }

  // Discounted return where the rocks of `good`, and no others, are good.
  float value(int cell, int wanted, int good) const {
    // Each rock is a ternary digit: not wanted, bad, good.
    const int digits = ternary_[wanted] + ternary_[wanted & good];
    return values_[static_cast<size_t>(digits) * map_.cellCount() + cell];
  }

 private:
  // Value iteration over the means; sets with fewer rocks are done.
  void planFor(int wanted) {
    std::vector<float> means(map_.cellCount(), 0.0F);
    for (bool changed = true; changed;) {
      changed = false;
      for (int cell = 0; cell < map_.cellCount(); ++cell) {
        for (int action = Action::kNorth; action <= Action::kSample; ++action) {
          const float mean = meanAfter(cell, wanted, action, means);
          if (mean <= means[cell]) continue;
          means[cell] = mean;
          actions_[wanted * map_.cellCount() + cell] = action;
          changed = true;
        }
      }
    }
    means_.insert(means_.end(), means.begin(), means.end());
    for (int good = wanted;; good = (good - 1) & wanted) {
      evaluate(wanted, good);
      if (good == 0) break;
    }
  }

  // kSample stands for a check, and a sample if it was good.
  float meanAfter(int cell, int wanted, int action, const std::vector<float>& means) const {
    if (action != Action::kSample) {
      const int to = map_.moved(cell, action);
      return to < 0 ? kExit : discount() * means[to];
    }
    const int rock = map_.rockAt(cell);
    if (rock < 0 || (wanted >> rock & 1) == 0) return 0.0F;
    const float rest = means_[(wanted & ~(1 << rock)) * map_.cellCount() + cell];
    return discount() * 0.5F * (kRock + discount() * rest + rest);
  }

  // Every way ends, so that a sweep for each of its steps is enough.
  void evaluate(int wanted, int good) {
    float* values =
        &values_[static_cast<size_t>(ternary_[wanted] + ternary_[good]) * map_.cellCount()];
    for (bool changed = true; changed;) {
      changed = false;
      for (int cell = 0; cell < map_.cellCount(); ++cell) {
        const float before = values[cell];
        values[cell] = valueAfter(cell, wanted, good);
        changed = changed || values[cell] != before;
      }
    }
  }

  float valueAfter(int cell, int wanted, int good) const {
    const int chosen = action(cell, wanted);
    if (chosen != Action::kSample) {
      const int to = map_.moved(cell, chosen);
      return to < 0 ? kExit : discount() * value(to, wanted, good);
    }
    const int rock = 1 << map_.rockAt(cell);
    const float rest = value(cell, wanted & ~rock, good);
    return discount() * ((good & rock) != 0 ? kRock + discount() * rest : rest);
  }

  static constexpr float kRock = 10.0F;
  static constexpr float kExit = 10.0F;

  float discount() const { return static_cast<float>(map_.discount); }

  RockSampleMap map_;
  std::vector<int> ternary_;  // of each set: its rocks as digits 1 of a ternary number
  std::vector<int> actions_;  // kSample: see meanAfter
  std::vector<float> means_;
  std::vector<float> values_;
};

}  // namespace pomdp_crowd_nav
