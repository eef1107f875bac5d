// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "pomdp_crowd_nav/world/track.h"
#include "pomdp_crowd_nav/world/vehicle.h"

namespace pomdp_crowd_nav {

// What a robot sweeps that goes on for a moment and then brakes to rest: a disc along a line or an
// arc. People go on at constant velocity.
class StoppingPath {
 public:
  struct Params {
    double distance = 1.0;       // [m], of a person's centre from the robot's
    double reaction_time = 0.2;  // [s] before the robot slows down
  };

  // With the brake and the limits of `vehicle`, whose distance from people is `params.distance`.
  StoppingPath(const Params& params, const VehicleParams& vehicle);

  // Id of somebody to whom the robot itself would come closer than the distance. Who runs into its
  // side or back is none, and neither is who comes up to a robot at rest. `curvature` [1/m] is that
  // of the robot's path.
  std::optional<std::int64_t> blockedBy(const VehicleState& robot, double curvature,
                                        const std::vector<Track>& people) const;

  // From now to rest.
  double duration(double speed) const;  // [s]
  double length(double speed) const;    // [m]

 private:
  struct Sample {
    double time = 0.0;
    Point position{0.0, 0.0};
    Point direction{1.0, 0.0};  // of travel
  };

  double distanceAt(double time, double speed) const;
  std::vector<Sample> sample(const VehicleState& robot, double curvature) const;
  bool isBlockedBy(const Track& person, const std::vector<Sample>& samples) const;

  Params params_;
  VehicleParams vehicle_;
};

}  // namespace pomdp_crowd_nav
