// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/prior/fast_marching_square_prior.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace pomdp_crowd_nav {
namespace {

constexpr double kEvenRadius = 3.0;  // [m], around the goal; see SourceDisc of ArrivalTimeField

}  // namespace

SpeedMap makeSquareSpeedMap(const ClearanceGrid& clearances, const Point& goal,
                            const PriorParams& params) {
  if (!(params.saturation_distance > 0.0)) {
    throw std::invalid_argument(fmt::format("prior.saturation_distance must be positive, got {}",
                                            params.saturation_distance));
  }
  SpeedMap speed_map = makeSpeedMap(clearances, params);
  const GridFrame& grid = speed_map.grid;
  const double at_goal = clearances.map.clearance(goal);
  for (int row = 0; row < grid.rows; ++row) {
    for (int column = 0; column < grid.columns; ++column) {
      const size_t cell = grid.index(column, row);
      const bool is_near = (grid.center(column, row) - goal).norm() < kEvenRadius;
      const double clearance = is_near ? at_goal : clearances.clearance[cell];
      const double share = clearance / params.saturation_distance;
      float& speed = speed_map.speed[cell];
      const auto slow = static_cast<float>(std::clamp(share, params.blocked_speed, 1.0));
      speed = std::min(speed, slow);
    }
  }
  return speed_map;
}

std::shared_ptr<const RolloutPrior> makeFastMarchingSquare(const ClearanceGrid& clearances,
                                                           const Point& goal,
                                                           const PriorParams& params) {
  return std::make_shared<FastMarchingPrior>(makeSquareSpeedMap(clearances, goal, params), goal);
}

}  // namespace pomdp_crowd_nav
