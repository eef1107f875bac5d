// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/prior/descent_directions.h"

#include <algorithm>
#include <limits>
#include <opencv2/imgproc.hpp>

#include "pomdp_crowd_nav/prior/in_halves.h"

namespace pomdp_crowd_nav {
namespace {

template <typename Visit>
void forEachNeighbour(const GridFrame& grid, int column, int row, Visit visit) {
  for (int r = std::max(0, row - 1); r <= std::min(grid.rows - 1, row + 1); ++r) {
    for (int c = std::max(0, column - 1); c <= std::min(grid.columns - 1, column + 1); ++c) {
      if (c != column || r != row) visit(c, r);
    }
  }
}

// T jumps at the edge of a slow area, and a gradient taken across the jump would drive a robot on
// a path along the edge away from it. So slow cells at the edge appear no later than the fast ones
// beside them: than the latest of those, lest a thin wall look like a way to its other side.
std::vector<float> timesWithoutJumps(const ArrivalTimeField& field, const SpeedMap& speed_map) {
  const GridFrame& grid = field.grid();
  constexpr float kJump = 2.0F;  // a neighbour faster by this factor is across an edge
  const float fastest = *std::max_element(speed_map.speed.begin(), speed_map.speed.end());
  std::vector<float> times = field.times();
  for (int row = 0; row < grid.rows; ++row) {
    for (int column = 0; column < grid.columns; ++column) {
      const size_t cell = grid.index(column, row);
      if (fastest < kJump * speed_map.speed[cell]) continue;
      float latest = -1.0F;
      forEachNeighbour(grid, column, row, [&](int c, int r) {
        const size_t beside = grid.index(c, r);
        if (speed_map.speed[beside] < kJump * speed_map.speed[cell]) return;
        latest = std::max(latest, field.times()[beside]);
      });
      if (latest >= 0.0F) times[cell] = std::min(times[cell], latest);
    }
  }
  return times;
}

// Continues three values in line by a fourth, by no more than the front passes in a cell.
float continued(float last, float second, float third, float crossing_time) {
  const float curved = 3.0F * (last - second) + third;
  return std::clamp(curved, last - crossing_time, last + crossing_time);
}

// The arrival times in a frame one cell wide that continues them, so that the gradient of a
// border cell is nearly as good as any.
cv::Mat framedTimes(const std::vector<float>& times, const SpeedMap& speed_map) {
  const GridFrame& grid = speed_map.grid;
  const int right = grid.columns;
  const int top = grid.rows;
  const auto crossingTime = [&](int column, int row) {
    return static_cast<float>(grid.resolution / speed_map.speed[grid.index(column, row)]);
  };
  cv::Mat_<float> framed(top + 2, right + 2);
  for (int row = 1; row <= top; ++row) {
    float* t = framed.ptr<float>(row);
    std::copy_n(&times[grid.index(0, row - 1)], right, t + 1);
    t[0] = continued(t[1], t[2], t[std::min(3, right)], crossingTime(0, row - 1));
    t[right + 1] = continued(t[right], t[right - 1], t[std::max(1, right - 2)],
                             crossingTime(right - 1, row - 1));
  }
  for (int column = 0; column <= right + 1; ++column) {
    const int inner = std::clamp(column - 1, 0, right - 1);
    const auto t = [&](int row) -> float& { return framed(row, column); };
    t(0) = continued(t(1), t(2), t(std::min(3, top)), crossingTime(inner, 0));
    t(top + 1) =
        continued(t(top), t(top - 1), t(std::max(1, top - 2)), crossingTime(inner, top - 1));
  }
  return framed;
}

// Descent along one axis, toward the earlier of the two neighbours.
double upwindDescent(float here, float before, float after) {
  const float descent = std::max(0.0F, here - std::min(before, after));
  return before < after ? -descent : descent;
}

// One-sided, so it goes one of the ways where two of them part.
Point upwindDescent(const ArrivalTimeField& field, int column, int row) {
  const GridFrame& grid = field.grid();
  const auto time = [&](int c, int r) {
    const bool on_grid = c >= 0 && c < grid.columns && r >= 0 && r < grid.rows;
    return on_grid ? field.times()[grid.index(c, r)] : std::numeric_limits<float>::infinity();
  };
  const float here = time(column, row);
  return {upwindDescent(here, time(column - 1, row), time(column + 1, row)),
          upwindDescent(here, time(column, row - 1), time(column, row + 1))};
}

// No shortest path leaves the grid.
Point keptOnGrid(const GridFrame& grid, int column, int row, Point direction) {
  if (column == 0) direction.x() = std::max(0.0, direction.x());
  if (column == grid.columns - 1) direction.x() = std::min(0.0, direction.x());
  if (row == 0) direction.y() = std::max(0.0, direction.y());
  if (row == grid.rows - 1) direction.y() = std::min(0.0, direction.y());
  return direction;
}

}  // namespace

Directions descentDirections(const ArrivalTimeField& field, const SpeedMap& speed_map) {
  const GridFrame& grid = field.grid();
  const cv::Mat framed = framedTimes(timesWithoutJumps(field, speed_map), speed_map);
  const double scale = 1.0 / (8.0 * grid.resolution);  // the Sobel weights span 8 cells
  cv::Mat_<float> slope_x, slope_y;
  cv::Sobel(framed, slope_x, CV_32F, 1, 0, 3, scale);
  cv::Sobel(framed, slope_y, CV_32F, 0, 1, 3, scale);

  // Where two ways of equal length part, their slopes cancel in the central differences.
  constexpr double kLeastSlope = 0.9;  // of the slope 1 / speed of a single way
  Directions directions;
  directions.x.resize(grid.cellCount());
  directions.y.resize(grid.cellCount());
  inHalves(grid.rows, [&](int first_row, int last_row) {
    for (int row = first_row; row < last_row; ++row) {
      for (int column = 0; column < grid.columns; ++column) {
        const size_t cell = grid.index(column, row);
        const Point descent(-slope_x(row + 1, column + 1), -slope_y(row + 1, column + 1));
        Point direction = keptOnGrid(grid, column, row, descent);
        if (direction.norm() * speed_map.speed[cell] < kLeastSlope) {
          direction = upwindDescent(field, column, row);
        }
        direction.normalize();
        directions.x[cell] = static_cast<float>(direction.x());
        directions.y[cell] = static_cast<float>(direction.y());
      }
    }
  });
  return directions;
}

}  // namespace pomdp_crowd_nav
