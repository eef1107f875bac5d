// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "pomdp_crowd_nav/world/geometry.h"

namespace pomdp_crowd_nav {

// What one person is about to do, as probabilities that sum to one: walk to one of the
// destinations, stand, or walk on elsewhere. A *hypothesis* is the index of a destination,
// kStanding or kElsewhere. In the paper there are destinations only (section Tracking POMDP
// Belief); standing and elsewhere then have probability 0 and keep it.
class IntentionBelief {
 public:
  static constexpr size_t kStanding = SIZE_MAX - 1;
  static constexpr size_t kElsewhere = SIZE_MAX;

  // Uniform over the destinations, which share what `standing` and `elsewhere` leave. Throws
  // std::invalid_argument when there is no destination.
  explicit IntentionBelief(size_t destination_count, double standing = 0.0, double elsewhere = 0.0);

  // The paper's rule: b'(j) ~ b(j) w_j with w_j = p_j + |min_k p_k| + 1, where p_j is the progress
  // [m] made toward destination j by walking from `from` to `to`.
  void update(const Point& from, const Point& to, const std::vector<Point>& destinations);

  // In proportion to weights of at least 0; none of them positive, or one not finite: ignored.
  void assign(std::vector<double> destinations, double standing, double elsewhere);

  const std::vector<double>& probabilities() const { return probabilities_; }  // of destinations
  double standing() const { return standing_; }
  double elsewhere() const { return elsewhere_; }
  double probability(size_t hypothesis) const;

  size_t mostLikely() const;  // hypothesis

  // Hypothesis at the quantile `uniform` in [0, 1) of the distribution.
  size_t sample(double uniform) const;

 private:
  std::vector<double> probabilities_;
  double standing_ = 0.0;
  double elsewhere_ = 0.0;
};

}  // namespace pomdp_crowd_nav
