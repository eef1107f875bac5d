// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "pomdp_crowd_nav/prior/cell_raster.h"
#include "pomdp_crowd_nav/prior/clearance_grid.h"
#include "pomdp_crowd_nav/prior/rollout_prior.h"
#include "pomdp_crowd_nav/world/static_map.h"

namespace pomdp_crowd_nav {

// What the search needs to know of a place, sampled at the centre of its cell.
struct NavigationCell {
  float direction_x = 0.0F;  // unit vector of travel toward the goal, (0, 0) if unreachable
  float direction_y = 0.0F;
  float clearance = 0.0F;         // [m] to the nearest obstacle, 1e6 on a map without
  float distance_to_goal = 0.0F;  // [m] along the prior's path, 1e6 if unreachable
};

// A unit vector in one word, to 2e-5: x in the low, y in the high half, in steps of 1/32767. A
// table of them stays in the cache where one of floats would not.
using PackedDirection = std::int32_t;
constexpr float kPackedUnit = 1.0F / 32767.0F;

PackedDirection packDirection(double x, double y);

// A prior and the clearance of the map as tables, so that the search makes no virtual call and
// pays the same for every prior. Nearest-cell lookup; places off the map read the border cell.
class NavigationField {
 public:
  // `resolution` [m] per cell; throws std::invalid_argument unless it is positive.
  NavigationField(const RolloutPrior& prior, const StaticMap& map, double resolution)
      : NavigationField(prior, ClearanceGrid(map, resolution)) {}

  // The prior must be of the same map.
  NavigationField(const RolloutPrior& prior, const ClearanceGrid& clearances);

  NavigationCell at(float x, float y) const {
    const auto cell = static_cast<size_t>(cellOf(x, y));
    const auto direction = static_cast<std::uint32_t>(directions_[cell]);
    return {static_cast<float>(static_cast<std::int16_t>(direction & 0xFFFFU)) * kPackedUnit,
            static_cast<float>(static_cast<std::int16_t>(direction >> 16)) * kPackedUnit,
            clearances_[cell], distances_[cell]};
  }

  int cellOf(float x, float y) const { return raster_.cellOf(x, y); }
  const CellRaster& raster() const { return raster_; }
  const PackedDirection* directions() const { return directions_.data(); }
  const float* clearances() const { return clearances_.data(); }  // [m]

  const Point& goal() const { return goal_; }
  const Bounds& bounds() const { return bounds_; }
  bool hasObstacles() const { return has_obstacles_; }
  bool isStraightLine() const { return is_straight_line_; }  // see RolloutPrior

 private:
  Bounds bounds_;
  Point goal_;
  bool has_obstacles_;
  bool is_straight_line_;
  CellRaster raster_;
  std::vector<PackedDirection> directions_;
  std::vector<float> clearances_;
  std::vector<float> distances_;
};

}  // namespace pomdp_crowd_nav
