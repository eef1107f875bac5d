// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/world/pedestrian.h"

#include <fmt/format.h>

#include <stdexcept>

namespace pomdp_crowd_nav {

StraightLinePedestrian::StraightLinePedestrian(const Params& params) : params_(params) {
  if (params.noise_per_step >= 0.0) return;
  throw std::invalid_argument(
      fmt::format("pedestrian noise must not be negative, got {}", params.noise_per_step));
}

Point StraightLinePedestrian::advance(const Pedestrian& pedestrian, double duration,
                                      double noise) const {
  const Point to_destination = pedestrian.destination - pedestrian.position;
  const double distance = to_destination.norm();
  if (distance == 0.0) return pedestrian.position;
  const double length = pedestrian.speed * duration + noise * params_.noise_per_step;
  return pedestrian.position + length / distance * to_destination;
}

}  // namespace pomdp_crowd_nav
