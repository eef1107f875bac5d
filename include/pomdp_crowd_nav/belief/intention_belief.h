// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "pomdp_crowd_nav/world/geometry.h"

namespace pomdp_crowd_nav {

// Probability of each destination of one person (paper, section Tracking POMDP Belief).
class IntentionBelief {
 public:
  // Uniform. Throws std::invalid_argument when there is no destination.
  explicit IntentionBelief(size_t destination_count);

  // b'(j) ~ b(j) w_j with w_j = p_j + |min_k p_k| + 1, where p_j is the progress [m] made toward
  // destination j by walking from `from` to `to`.
  void update(const Point& from, const Point& to, const std::vector<Point>& destinations);

  const std::vector<double>& probabilities() const { return probabilities_; }
  size_t mostLikely() const;

  // Destination at the quantile `uniform` in [0, 1) of the distribution.
  size_t sample(double uniform) const;

 private:
  std::vector<double> probabilities_;
};

}  // namespace pomdp_crowd_nav
