// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "pomdp_crowd_nav/belief/belief_tracker.h"
#include "pomdp_crowd_nav/sim/tracks_file.h"
#include "pomdp_crowd_nav/world/static_map.h"

namespace pomdp_crowd_nav {

// How well sampled futures of people agree with where they really were then; means.
struct PredictionScore {
  long count = 0;            // people, at every sweep anew
  double log_density = 0.0;  // of the real place under the futures, smoothed by a kernel [1/m^2]
  double error = 0.0;        // [m], from a future to the real place
  double near_share = 0.0;   // of the futures that are near the real place
};

// Scores of predictions this far ahead.
struct PredictionScores {
  double horizon = 0.0;  // [s]
  PredictionScore all;   // everybody seen for `history` already
  PredictionScore slow;  // of these who walked slowly in that time, or stood
};

// How people are predicted and what is compared.
struct PredictionParams {
  BeliefTracker::Params belief;
  double pedestrian_noise = 0.2;  // [m], half width of the noise on a walk of 1 s
  int horizons = 4;               // 1 s, 2 s, ...
  int scenarios = 100;
  double kernel = 0.3;      // [m], standard deviation
  double floor = 0.01;      // of the density, that is uniform on the field
  double near = 0.6;        // [m]
  double history = 1.2;     // [s]
  double slow_speed = 0.3;  // [m/s]
  std::uint64_t seed = 1;
};

// Runs the belief over the sweeps of a recording and compares, at each of them, the futures drawn
// from it (CrowdFutures) with the rest of the recording.
std::vector<PredictionScores> scorePredictions(const std::vector<TrackSample>& recording,
                                               const std::vector<Point>& destinations,
                                               const Bounds& bounds,
                                               const PredictionParams& params);

// All horizons together.
PredictionScores overall(const std::vector<PredictionScores>& scores);

}  // namespace pomdp_crowd_nav
