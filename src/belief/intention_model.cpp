// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/belief/intention_model.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace pomdp_crowd_nav {
namespace {

constexpr double kAnyWalk =
    1.0;  // [m/s], standard deviation of a velocity of which nothing is known

void require(bool fits, const char* name, const char* expected, double value) {
  if (fits && std::isfinite(value)) return;
  throw std::invalid_argument(fmt::format("belief.{} must {}, got {}", name, expected, value));
}

Point directionTo(const Point& destination, const Point& from) {
  const Point way = destination - from;
  const double length = way.norm();
  return length > 0.0 ? Point(way / length) : Point(0.0, 0.0);
}

}  // namespace

IntentionModel::IntentionModel(const Params& params) : params_(params) {
  const Params& p = params_;
  require(p.position_noise >= 0.0, "position_noise", "not be negative", p.position_noise);
  require(p.change_rate >= 0.0, "change_rate", "not be negative", p.change_rate);
  require(p.sway > 0.0, "sway", "be positive", p.sway);
  require(p.walking_noise > 0.0, "walking_noise", "be positive", p.walking_noise);
  require(p.elsewhere_noise > 0.0, "elsewhere_noise", "be positive", p.elsewhere_noise);
  require(p.slowest >= 0.0, "slowest", "not be negative", p.slowest);
  require(p.standing >= 0.0, "standing", "not be negative", p.standing);
  require(p.elsewhere >= 0.0 && p.standing + p.elsewhere < 1.0, "elsewhere",
          "not be negative and leave something to destinations", p.elsewhere);
}

IntentionBelief IntentionModel::firstBelief(size_t destination_count) const {
  return IntentionBelief(destination_count, params_.standing, params_.elsewhere);
}

// But for a constant.
double IntentionModel::logLikelihood(const Point& off, double noise, double duration) const {
  const double walked = noise * duration;
  const double both_ends = 2.0 * params_.position_noise * params_.position_noise;
  const double variance = both_ends + walked * walked;
  return -0.5 * off.squaredNorm() / variance - std::log(variance);
}

double IntentionModel::logLikelihoodElsewhere(const ObservedWalk& walk) const {
  const Point moved = walk.to - walk.from;
  if (!walk.velocity || walk.velocity->isZero()) {
    return logLikelihood(moved, kAnyWalk, walk.duration);
  }
  const double speed = walk.velocity->norm();
  const Point expected = std::max(1.0, params_.slowest / speed) * walk.duration * *walk.velocity;
  return logLikelihood(moved - expected, params_.elsewhere_noise, walk.duration);
}

void IntentionModel::update(const ObservedWalk& walk, const std::vector<Point>& destinations,
                            IntentionBelief& belief) const {
  const std::vector<double>& before = belief.probabilities();
  if (destinations.size() != before.size()) {
    throw std::invalid_argument(fmt::format("belief over {} destinations updated with {}",
                                            before.size(), destinations.size()));
  }
  const Point moved = walk.to - walk.from;
  const double speed = std::max(walk.speed, params_.slowest);
  std::vector<double> weights(destinations.size());
  for (size_t j = 0; j < weights.size(); ++j) {
    const Point expected = speed * walk.duration * directionTo(destinations[j], walk.from);
    weights[j] = logLikelihood(moved - expected, params_.walking_noise, walk.duration);
  }
  const double stood = logLikelihood(moved, params_.sway, walk.duration);
  const double went_on = logLikelihoodElsewhere(walk);
  const double best = std::max({*std::max_element(weights.begin(), weights.end()), stood, went_on});

  // Who has changed its mind does what anybody might do.
  const double changed = -std::expm1(-params_.change_rate * walk.duration);
  const double first_share = (1.0 - params_.standing - params_.elsewhere) / weights.size();
  const auto prior = [changed](double kept, double first) {
    return (1.0 - changed) * kept + changed * first;
  };
  for (size_t j = 0; j < weights.size(); ++j) {
    weights[j] = prior(before[j], first_share) * std::exp(weights[j] - best);
  }
  belief.assign(std::move(weights),
                prior(belief.standing(), params_.standing) * std::exp(stood - best),
                prior(belief.elsewhere(), params_.elsewhere) * std::exp(went_on - best));
}

}  // namespace pomdp_crowd_nav
