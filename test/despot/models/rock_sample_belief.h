// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "rock_sample.h"
#include "weighted_states.h"

namespace pomdp_crowd_nav {

// The exact belief of RockSample: the rocks are independent of each other.
class RockSampleBelief {
 public:
  using Model = RockSample;

  explicit RockSampleBelief(const RockSample& model)
      : cell_(model.map().index(model.map().start)), good_(model.map().rockCount(), 0.5) {}

  int cell() const { return cell_; }
  double probabilityOfGood(int rock) const { return good_[rock]; }

  // Every set of good rocks that may be.
  std::vector<WeightedState<RockSample::State>> states() const {
    RockSample::State known;
    known.cell = static_cast<std::uint8_t>(cell_);
    for (size_t r = 0; r < good_.size(); ++r) known.log_odds[r] = logOdds(good_[r]);
    std::vector<WeightedState<RockSample::State>> all;
    for (int good = 0; good < 1 << good_.size(); ++good) {
      double weight = 1.0;
      for (size_t r = 0; r < good_.size(); ++r) {
        weight *= (good >> r & 1) != 0 ? good_[r] : 1.0 - good_[r];
      }
      if (weight <= 0.0) continue;
      all.push_back({known, weight});
      all.back().state.good = static_cast<std::uint8_t>(good);
    }
    return all;
  }

  void update(const RockSample& model, RockSample::Action action, std::uint64_t observation) {
    const RockSampleMap& map = model.map();
    if (action < RockSampleAction::kSample) {
      const int to = map.moved(cell_, action);
      if (to >= 0) cell_ = to;
    } else if (action == RockSampleAction::kSample) {
      if (map.rockAt(cell_) >= 0) good_[map.rockAt(cell_)] = 0.0;
    } else {
      const int rock = action - RockSampleAction::kCheck;
      const double truth = map.accuracy(cell_, rock);
      const bool looks_good = observation == RockSample::kLooksGood;
      const double if_good = good_[rock] * (looks_good ? truth : 1.0 - truth);
      const double if_bad = (1.0 - good_[rock]) * (looks_good ? 1.0 - truth : truth);
      good_[rock] = if_good / (if_good + if_bad);
    }
  }

 private:
  static std::int8_t logOdds(double probability) {
    const double units = std::log(probability / (1.0 - probability)) / RockSample::kEvidenceUnit;
    const double certain = RockSample::kCertain;
    return static_cast<std::int8_t>(std::lround(std::clamp(units, -certain, certain)));
  }

  int cell_;
  std::vector<double> good_;  // probabilities
};

}  // namespace pomdp_crowd_nav
