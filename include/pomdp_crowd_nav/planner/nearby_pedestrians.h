// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "pomdp_crowd_nav/belief/crowd_belief.h"
#include "pomdp_crowd_nav/world/vehicle.h"

namespace pomdp_crowd_nav {

struct AttentionParams {
  int pedestrians = 6;       // n_ped, at most this many people
  double half_angle = M_PI;  // [rad], of the cone around the direction of travel
  double close_range = 1.0;  // [m], anybody this close counts, in the cone or not
  // [s], who will be near by then, all going on as they do, is as near as who is near now
  double lookahead = 1.0;
};

// The people whose futures the search looks at: the nearest in the cone, by increasing id. With no
// lookahead this is the authors' rule.
std::vector<PersonBelief> nearbyPedestrians(const CrowdBelief& crowd, const VehicleState& vehicle,
                                            const AttentionParams& params);

}  // namespace pomdp_crowd_nav
