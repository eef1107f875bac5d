// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "pomdp_crowd_nav/belief/intention_belief.h"

namespace pomdp_crowd_nav {

// How one person moved between two updates, and the speeds at which it was expected to walk.
struct ObservedWalk {
  Point from{0.0, 0.0};           // [m]
  Point to{0.0, 0.0};             // [m]
  double duration = 0.5;          // [s]
  double speed = 1.0;             // [m/s], to a destination
  std::optional<Point> velocity;  // [m/s], elsewhere: that of before, where it is known
};

// Bayes' rule over destinations, standing and elsewhere. Each hypothesis expects a displacement;
// what is seen is normal about it, on each axis. People change their minds: at `change_rate` any
// hypothesis gives way to the first belief, so that none is ever too sure to be left.
class IntentionModel {
 public:
  struct Params {
    double position_noise = 0.1;   // [m], standard deviation of a tracked position on each axis
    double change_rate = 0.5;      // [1/s]
    double sway = 0.2;             // [m/s], of people who stand
    double walking_noise = 0.4;    // [m/s], about the straight walk to a destination
    double elsewhere_noise = 0.3;  // [m/s], about the velocity of before
    double slowest = 0.3;          // [m/s], of anybody who walks; who is slower stands
    double standing = 0.2;         // probability in a first belief
    double elsewhere = 0.4;        // probability in a first belief
  };

  // Throws std::invalid_argument for a parameter out of range.
  explicit IntentionModel(const Params& params);

  IntentionBelief firstBelief(size_t destination_count) const;

  void update(const ObservedWalk& walk, const std::vector<Point>& destinations,
              IntentionBelief& belief) const;

 private:
  double logLikelihood(const Point& off, double noise, double duration) const;
  double logLikelihoodElsewhere(const ObservedWalk& walk) const;

  Params params_;
};

}  // namespace pomdp_crowd_nav
