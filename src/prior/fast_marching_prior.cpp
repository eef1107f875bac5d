// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/prior/fast_marching_prior.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace pomdp_crowd_nav {
namespace {

constexpr double kStraightCells = 3.0;  // last cells before the goal

void require(bool holds, const char* name, const char* range, double value) {
  if (holds) return;
  throw std::invalid_argument(fmt::format("prior.{} must be {}, got {}", name, range, value));
}

void validate(const PriorParams& params) {
  require(params.resolution > 0.0, "resolution", "positive", params.resolution);
  require(params.clearance >= 0.0, "clearance", "at least 0", params.clearance);
  require(params.extra_clearance >= 0.0, "extra_clearance", "at least 0", params.extra_clearance);
  require(params.blocked_speed > 0.0 && params.blocked_speed < 1.0, "blocked_speed", "in (0, 1)",
          params.blocked_speed);
  require(params.narrow_speed >= params.blocked_speed && params.narrow_speed <= 1.0, "narrow_speed",
          "between prior.blocked_speed and 1", params.narrow_speed);
}

}  // namespace

SpeedMap makeSpeedMap(const StaticMap& map, const PriorParams& params) {
  validate(params);
  return makeSpeedMap(ClearanceGrid(map, params.resolution), params);
}

SpeedMap makeSpeedMap(const ClearanceGrid& clearances, const PriorParams& params) {
  validate(params);
  SpeedMap speed_map{clearances.grid, {}};
  const double kept_clearance = params.clearance + params.extra_clearance;
  const auto blocked_speed = static_cast<float>(params.blocked_speed);
  const auto narrow_speed = static_cast<float>(params.narrow_speed);
  const double touch = M_SQRT1_2 * clearances.grid.resolution;  // of a cell, from its centre
  speed_map.speed.reserve(clearances.clearance.size());
  for (const double clearance : clearances.clearance) {
    float speed = 1.0F;
    if (clearance < kept_clearance) speed = narrow_speed;
    if (clearance < std::min(kept_clearance, params.robot_radius)) speed = blocked_speed;
    if (clearance <= touch) speed = 0.1F * blocked_speed;
    speed_map.speed.push_back(speed);
  }
  return speed_map;
}

FastMarchingPrior::FastMarchingPrior(const StaticMap& map, const Point& goal,
                                     const PriorParams& params)
    : FastMarchingPrior(makeSpeedMap(map, params), goal) {}

FastMarchingPrior::FastMarchingPrior(const SpeedMap& speed_map, const Point& goal)
    : field_(speed_map, goal), directions_(descentDirections(field_, speed_map)) {}

// By the length of the path, not of the straight line, which may cross a wall.
bool FastMarchingPrior::isNearGoal(double path_length) const {
  return path_length < kStraightCells * field_.grid().resolution;
}

// Nearly a unit vector; (0, 0) on a plateau, as rounding leaves behind very slow cells.
Point FastMarchingPrior::descentAt(const Point& position) const {
  // Between cells from which different ways lead to the goal, their mean is neither of them.
  constexpr double kLeastAgreement = 0.95;
  const GridFrame& grid = field_.grid();
  const Point half_cell = Point::Constant(0.5 * grid.resolution);
  const Point last_center = grid.center(grid.columns - 1, grid.rows - 1);
  const Point place = position.cwiseMax(grid.origin + half_cell).cwiseMin(last_center);
  const BilinearWeights weights = bilinearWeights(grid, place);
  const Point direction(interpolate(grid, directions_.x, weights),
                        interpolate(grid, directions_.y, weights));
  if (direction.norm() >= kLeastAgreement) return direction;
  const size_t cell = grid.index(grid.columnOf(position), grid.rowOf(position));
  return {directions_.x[cell], directions_.y[cell]};
}

std::optional<double> FastMarchingPrior::directionAt(const Pose& pose) const {
  const Point& position = pose.position;
  if (!field_.grid().contains(position)) return std::nullopt;
  if (isNearGoal(field_.pathLengthAt(position))) return bearing(position, goal());
  const Point descent = descentAt(position);
  return descent.isZero(0.0) ? std::nullopt : std::optional<double>(bearing({0.0, 0.0}, descent));
}

double FastMarchingPrior::distanceToGoal(const Point& position) const {
  if (!field_.grid().contains(position)) return std::numeric_limits<double>::infinity();
  const double path_length = field_.pathLengthAt(position);
  return isNearGoal(path_length) ? (position - goal()).norm() : path_length;
}

Course FastMarchingPrior::courseAt(const Pose& pose) const {
  const Point& position = pose.position;
  if (!field_.grid().contains(position)) {
    return {Point(0.0, 0.0), std::numeric_limits<double>::infinity()};
  }
  const double path_length = field_.pathLengthAt(position);
  if (isNearGoal(path_length)) {
    return {unitVector(bearing(position, goal())), (position - goal()).norm()};
  }
  return {descentAt(position).normalized(), path_length};
}

}  // namespace pomdp_crowd_nav
