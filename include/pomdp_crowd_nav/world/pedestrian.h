// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pomdp_crowd_nav/world/geometry.h"

namespace pomdp_crowd_nav {

// A person on the way to a destination.
struct Pedestrian {
  Point position{0.0, 0.0};     // [m]
  Point destination{0.0, 0.0};  // [m]
  double speed = 1.0;           // [m/s]
};

// How people walk. `noise` is uniform in [-1, 1] and comes from the caller, so that the model
// holds no random state and the same noise gives the same walk.
class PedestrianModel {
 public:
  virtual ~PedestrianModel() = default;

  // Position after `duration` seconds.
  virtual Point advance(const Pedestrian& pedestrian, double duration, double noise) const = 0;
};

// The paper's model: straight toward the destination by speed * duration plus noise, whatever
// stands in the way (section Generative Model G).
class StraightLinePedestrian : public PedestrianModel {
 public:
  struct Params {
    double noise_per_step = 0.1;  // [m], half width of the uniform noise on one step's length
  };

  explicit StraightLinePedestrian(const Params& params);

  Point advance(const Pedestrian& pedestrian, double duration, double noise) const override;

 private:
  Params params_;
};

}  // namespace pomdp_crowd_nav
