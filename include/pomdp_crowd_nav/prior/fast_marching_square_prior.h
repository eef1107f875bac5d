// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "pomdp_crowd_nav/prior/fast_marching_prior.h"

namespace pomdp_crowd_nav {

// Speed of the front for Fast Marching Square: as makeSpeedMap inside the clearance; outside it
// grows in proportion to the distance from the nearest obstacle until it is 1 at
// `saturation_distance`. Within 3 m of the goal it is that of the goal, so that the front starts
// evenly. Throws std::invalid_argument naming the first parameter out of range.
SpeedMap makeSquareSpeedMap(const ClearanceGrid& clearances, const Point& goal,
                            const PriorParams& params);

// Fast Marching Square (Gomez, Lumbier, Garrido, Moreno 2013): the front is the faster the farther
// it is from obstacles, so paths swing wide round them and bend gently.
std::shared_ptr<const RolloutPrior> makeFastMarchingSquare(const ClearanceGrid& clearances,
                                                           const Point& goal,
                                                           const PriorParams& params);

}  // namespace pomdp_crowd_nav
