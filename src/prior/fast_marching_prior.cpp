// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/prior/fast_marching_prior.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>
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
}

// The arrival times in a frame one cell wide that goes on as straight as the two cells inside it,
// so that the gradient of a border cell is as good as any.
cv::Mat framedTimes(const ArrivalTimeField& field) {
  const GridFrame& grid = field.grid();
  cv::Mat framed(grid.rows + 2, grid.columns + 2, CV_32F);
  for (int row = 0; row < grid.rows; ++row) {
    float* cells = framed.ptr<float>(row + 1);
    std::copy_n(&field.times()[grid.index(0, row)], grid.columns, cells + 1);
    cells[0] = 2.0F * cells[1] - cells[2];
    cells[grid.columns + 1] = 2.0F * cells[grid.columns] - cells[grid.columns - 1];
  }
  framed.row(0) = 2.0 * framed.row(1) - framed.row(2);
  framed.row(grid.rows + 1) = 2.0 * framed.row(grid.rows) - framed.row(grid.rows - 1);
  return framed;
}

struct CellOffset {
  int column, row;
};
constexpr CellOffset kAround[] = {{1, 0},  {1, 1},   {0, 1},  {-1, 1},
                                  {-1, 0}, {-1, -1}, {0, -1}, {1, -1}};

// Toward the neighbour with the steepest descent.
Point toLowestNeighbour(const cv::Mat& framed, int column, int row) {
  const float here = framed.at<float>(row + 1, column + 1);
  double steepest = -std::numeric_limits<double>::infinity();
  Point direction(0.0, 0.0);
  for (const CellOffset& offset : kAround) {
    const Point way(offset.column, offset.row);
    const float there = framed.at<float>(row + 1 + offset.row, column + 1 + offset.column);
    const double descent = (here - there) / way.norm();
    if (descent <= steepest) continue;
    steepest = descent;
    direction = way.normalized();
  }
  return direction;
}

}  // namespace

SpeedMap makeSpeedMap(const StaticMap& map, const PriorParams& params) {
  validate(params);
  SpeedMap speed_map{coveringGrid(map.bounds(), params.resolution), {}};
  const GridFrame& grid = speed_map.grid;
  const double kept_clearance = params.clearance + params.extra_clearance;
  const auto blocked_speed = static_cast<float>(params.blocked_speed);
  speed_map.speed.reserve(grid.cellCount());
  for (int row = 0; row < grid.rows; ++row) {
    for (int column = 0; column < grid.columns; ++column) {
      const double clearance = map.clearance(grid.center(column, row));
      const float inside = clearance > 0.0 ? blocked_speed : 0.1F * blocked_speed;
      speed_map.speed.push_back(clearance >= kept_clearance && clearance > 0.0 ? 1.0F : inside);
    }
  }
  return speed_map;
}

FastMarchingPrior::FastMarchingPrior(const StaticMap& map, const Point& goal,
                                     const PriorParams& params)
    : FastMarchingPrior(makeSpeedMap(map, params), goal) {}

FastMarchingPrior::FastMarchingPrior(const SpeedMap& speed_map, const Point& goal)
    : field_(speed_map, goal) {
  const GridFrame& grid = field_.grid();
  const cv::Mat framed = framedTimes(field_);
  const double scale = 1.0 / (8.0 * grid.resolution);  // the Sobel weights add up to 8 cells
  cv::Mat gradient_x, gradient_y;
  cv::Sobel(framed, gradient_x, CV_32F, 1, 0, 3, scale);
  cv::Sobel(framed, gradient_y, CV_32F, 0, 1, 3, scale);

  // Where two ways to the goal of equal length meet, their slopes cancel: take one of them.
  constexpr double kLeastSlope = 0.5;
  direction_x_.reserve(grid.cellCount());
  direction_y_.reserve(grid.cellCount());
  for (int row = 0; row < grid.rows; ++row) {
    for (int column = 0; column < grid.columns; ++column) {
      const Point descent(-gradient_x.at<float>(row + 1, column + 1),
                          -gradient_y.at<float>(row + 1, column + 1));
      const double slope = descent.norm() * speed_map.speed[grid.index(column, row)];
      const Point direction = slope < kLeastSlope ? toLowestNeighbour(framed, column, row)
                                                  : Point(descent.normalized());
      direction_x_.push_back(static_cast<float>(direction.x()));
      direction_y_.push_back(static_cast<float>(direction.y()));
    }
  }
}

// By the length of the path, not of the straight line, which may cross a wall.
bool FastMarchingPrior::isNearGoal(const Point& position) const {
  return field_.pathLengthAt(position) < kStraightCells * field_.grid().resolution;
}

std::optional<double> FastMarchingPrior::directionAt(const Pose& pose) const {
  const Point& position = pose.position;
  const GridFrame& grid = field_.grid();
  if (!grid.contains(position)) return std::nullopt;
  if (isNearGoal(position)) return bearing(position, goal());

  // Opposite directions cancel where two ways to the goal part: take that of the cell itself.
  constexpr double kLeastAgreement = 0.3;
  Point direction(interpolate(grid, direction_x_, position),
                  interpolate(grid, direction_y_, position));
  if (direction.norm() < kLeastAgreement) {
    const size_t cell = grid.index(grid.columnOf(position), grid.rowOf(position));
    direction = {direction_x_[cell], direction_y_[cell]};
  }
  return bearing({0.0, 0.0}, direction);
}

double FastMarchingPrior::distanceToGoal(const Point& position) const {
  if (!field_.grid().contains(position)) return std::numeric_limits<double>::infinity();
  if (isNearGoal(position)) return (position - goal()).norm();
  return field_.pathLengthAt(position);
}

}  // namespace pomdp_crowd_nav
