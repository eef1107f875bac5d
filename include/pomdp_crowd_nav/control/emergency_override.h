// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "pomdp_crowd_nav/planner/planner.h"
#include "pomdp_crowd_nav/world/track.h"

namespace pomdp_crowd_nav {

// The layer below the planner: whoever is too close stops the robot, whether the search attended
// to that person or not.
class EmergencyOverride {
 public:
  struct Params {
    bool enabled = true;
    // [m], at decision time: closer than this the robot stays at rest, slows down, or brakes
    // (facts sheet, section 3)
    double decision_distance = 2.0;
    // [m], between decisions: the robot brakes when, going on as it does, it would come this
    // close to a person before it could rest
    double reflex_distance = 1.2;
    double reaction_time = 0.2;  // [s], age of the tracks and delay of the base together
  };

  EmergencyOverride(const Params& params, const VehicleParams& vehicle, double step);

  // The action to take instead of the planned one, if any: stay at rest, slow down by one speed
  // step when that stops the robot, else sudden brake.
  std::optional<Action> replace(const VehicleState& vehicle, const TrackList& tracks) const;

  // Id of a person for whom the robot must brake now, in the middle of a step. `yaw_rate` [rad/s]
  // of a car, which on ramps brakes on the curve that it drives.
  std::optional<std::int64_t> reflex(const VehicleState& vehicle, const TrackList& tracks,
                                     double yaw_rate = 0.0) const;

  // `motion` and `plan` of a decision whose action is replaced.
  void apply(const Action& action, const VehicleState& vehicle, Decision& decision) const;

 private:
  Params params_;
  VehicleParams vehicle_;
  double step_;
};

}  // namespace pomdp_crowd_nav
