// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/belief/intention_belief.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

namespace pomdp_crowd_nav {

IntentionBelief::IntentionBelief(size_t destination_count) {
  if (destination_count == 0) throw std::invalid_argument("destinations must not be empty");
  probabilities_.assign(destination_count, 1.0 / static_cast<double>(destination_count));
}

void IntentionBelief::update(const Point& from, const Point& to,
                             const std::vector<Point>& destinations) {
  if (destinations.size() != probabilities_.size()) {
    throw std::invalid_argument(fmt::format("belief over {} destinations updated with {}",
                                            probabilities_.size(), destinations.size()));
  }
  std::vector<double> posterior(destinations.size());
  double smallest = std::numeric_limits<double>::infinity();
  for (size_t j = 0; j < destinations.size(); ++j) {
    const double progress = (destinations[j] - from).norm() - (destinations[j] - to).norm();
    posterior[j] = progress;
    smallest = std::min(smallest, progress);
  }
  double total = 0.0;
  for (size_t j = 0; j < posterior.size(); ++j) {
    posterior[j] = probabilities_[j] * (posterior[j] + std::abs(smallest) + 1.0);
    total += posterior[j];
  }
  if (!std::isfinite(total) || total <= 0.0) return;  // a step beyond the range of double
  for (double& probability : posterior) probability /= total;
  probabilities_ = std::move(posterior);
}

size_t IntentionBelief::mostLikely() const {
  const auto best = std::max_element(probabilities_.begin(), probabilities_.end());
  return static_cast<size_t>(best - probabilities_.begin());
}

size_t IntentionBelief::sample(double uniform) const {
  double cumulative = 0.0;
  for (size_t j = 0; j < probabilities_.size(); ++j) {
    cumulative += probabilities_[j];
    if (uniform < cumulative) return j;
  }
  return mostLikely();  // the probabilities sum to a hair less than one
}

}  // namespace pomdp_crowd_nav
