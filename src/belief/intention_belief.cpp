// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/belief/intention_belief.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

namespace pomdp_crowd_nav {

IntentionBelief::IntentionBelief(size_t destination_count, double standing, double elsewhere)
    : standing_(standing), elsewhere_(elsewhere) {
  if (destination_count == 0) throw std::invalid_argument("destinations must not be empty");
  const double share = (1.0 - standing - elsewhere) / static_cast<double>(destination_count);
  probabilities_.assign(destination_count, share);
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
  for (size_t j = 0; j < posterior.size(); ++j) {
    posterior[j] = probabilities_[j] * (posterior[j] + std::abs(smallest) + 1.0);
  }
  assign(std::move(posterior), standing_, elsewhere_);
}

void IntentionBelief::assign(std::vector<double> destinations, double standing, double elsewhere) {
  double total = 0.0;
  for (const double weight : destinations) total += weight;
  total += standing + elsewhere;
  if (!std::isfinite(total) || total <= 0.0) return;  // a step beyond the range of double
  for (double& weight : destinations) weight /= total;
  probabilities_ = std::move(destinations);
  standing_ = standing / total;
  elsewhere_ = elsewhere / total;
}

double IntentionBelief::probability(size_t hypothesis) const {
  if (hypothesis == kStanding) return standing_;
  return hypothesis == kElsewhere ? elsewhere_ : probabilities_[hypothesis];
}

size_t IntentionBelief::mostLikely() const {
  const auto best = std::max_element(probabilities_.begin(), probabilities_.end());
  if (*best >= std::max(standing_, elsewhere_)) {
    return static_cast<size_t>(best - probabilities_.begin());
  }
  return standing_ >= elsewhere_ ? kStanding : kElsewhere;
}

size_t IntentionBelief::sample(double uniform) const {
  double cumulative = 0.0;
  for (size_t j = 0; j < probabilities_.size(); ++j) {
    cumulative += probabilities_[j];
    if (uniform < cumulative) return j;
  }
  if (uniform < cumulative + standing_) return kStanding;
  if (uniform < cumulative + standing_ + elsewhere_) return kElsewhere;
  return mostLikely();  // the probabilities sum to a hair less than one
}

}  // namespace pomdp_crowd_nav
