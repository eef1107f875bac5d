// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/prior/shortest_way.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "pomdp_crowd_nav/prior/arrival_time_field.h"
#include "pomdp_crowd_nav/prior/quad.h"

namespace pomdp_crowd_nav {
namespace {

constexpr double kRounding = 0.01;       // [m] given away, so that float errors stay optimistic
constexpr double kScaleRounding = 1e-4;  // the same as a share of the length
constexpr double kUnreachable = 1e5;     // [s], a front that takes longer has crossed a closed cell

void validate(const ShortestWay::Params& p) {
  const auto require = [](const char* name, double value) {
    if (value >= 0.0) return;
    throw std::invalid_argument(
        fmt::format("shortest_way.{} must be at least 0, got {}", name, value));
  };
  require("clearance", p.clearance);
  require("stride", p.stride);
  require("goal_tolerance", p.goal_tolerance);
}

// The grid as places see it that find their cells with float precision.
GridFrame frameOf(const CellRaster& raster) {
  return {{raster.min_x, raster.min_y},
          1.0 / raster.cells_per_meter,
          raster.columns,
          static_cast<int>(raster.last_row) + 1};
}

// The nearest place that has cell centres on all sides.
Point betweenCenters(const GridFrame& grid, const Point& point) {
  return point.cwiseMax(grid.center(0, 0)).cwiseMin(grid.center(grid.columns - 1, grid.rows - 1));
}

double leastOpenClearance(const ShortestWay::Params& params, const StaticMap& map, double cell) {
  const auto& grid = map.obstacles().grid;
  const double error = grid ? M_SQRT1_2 * grid->resolution : 0.0;
  const double corner = params.clearance - M_SQRT1_2 * cell - error;
  const double sag = 0.25 * params.stride;
  if (corner < sag) return std::numeric_limits<double>::infinity();
  return std::sqrt(corner * corner - sag * sag) - M_SQRT2 * cell - error;
}

// Speed of the front: 1 in open cells. Beside them it falls over a few cells, for a sharp border
// is a staircase, and each of its corners would be the source of a steep fan.
SpeedMap makeSpeedMap(const GridFrame& grid, const std::vector<double>& clearances,
                      double open_clearance) {
  constexpr double kHalved = 3.0;  // [cells] from the open ones the speed is halved
  constexpr double kLayer = 6.0;   // [cells]
  const auto closed = static_cast<float>(1e-6 * grid.resolution);
  SpeedMap map{grid, std::vector<float>(grid.cellCount(), closed)};
  for (size_t cell = 0; cell < map.speed.size(); ++cell) {
    const auto clearance = static_cast<float>(clearances[cell]);
    const double depth = (open_clearance - clearance) / grid.resolution;
    if (depth < 0.0) {
      map.speed[cell] = 1.0F;
    } else if (depth < kLayer && clearance > grid.resolution) {
      map.speed[cell] = static_cast<float>(kHalved / (kHalved + depth));
    }
  }
  return map;
}

// Where an occupancy grid tells no more than a lower limit of the clearance.
void openOffGrid(const OccupancyGrid& obstacles, SpeedMap& map) {
  for (int row = 0; row < map.grid.rows; ++row) {
    for (int column = 0; column < map.grid.columns; ++column) {
      const Point offset = map.grid.center(column, row) - obstacles.origin;
      const Point cell = offset / obstacles.resolution;
      const bool is_on =
          cell.minCoeff() >= 0.0 && cell.x() <= obstacles.columns && cell.y() <= obstacles.rows;
      if (!is_on) map.speed[map.grid.index(column, row)] = 1.0F;
    }
  }
}

// The cells around a place, as far as `radius` [m].
template <typename Visit>
void forEachNear(const GridFrame& grid, const Point& place, double radius, Visit visit) {
  const Point reach(radius, radius);
  for (int row = grid.rowOf(place - reach); row <= grid.rowOf(place + reach); ++row) {
    for (int column = grid.columnOf(place - reach); column <= grid.columnOf(place + reach);
         ++column) {
      const double distance = (grid.center(column, row) - place).norm();
      if (distance <= radius) visit(grid.index(column, row), distance);
    }
  }
}

// Lower left cells of the quads that a drive may pass: open, and the front got there.
std::vector<size_t> openQuads(const SpeedMap& map, const std::vector<float>& times) {
  const auto is_open = [&](size_t cell) {
    return map.speed[cell] == 1.0F && times[cell] < kUnreachable;
  };
  const GridFrame& grid = map.grid;
  std::vector<size_t> quads;
  for (int row = 0; row + 1 < grid.rows; ++row) {
    for (int column = 0; column + 1 < grid.columns; ++column) {
      const size_t lower = grid.index(column, row);
      const size_t upper = lower + grid.columns;
      if (is_open(lower) && is_open(lower + 1) && is_open(upper) && is_open(upper + 1)) {
        quads.push_back(lower);
      }
    }
  }
  return quads;
}

// The table over the open quads, on its way from arrival times to lengths.
class Surface {
 public:
  Surface(const GridFrame& grid, std::vector<size_t> quads, std::vector<float>& values)
      : grid_(grid), quads_(std::move(quads)), values_(values) {}

  double steepest() const {
    double slope = 0.0;
    for (const size_t quad : quads_) slope = std::max(slope, slopeOf(quad));
    return slope;
  }

  // Divides the gradient at each level, in steps of a cell, by the steepest there.
  void flatten() {
    const double level = grid_.resolution;
    const std::vector<double> slopes = steepestByLevel(level);
    std::vector<double> flattened{0.0};
    for (const double slope : slopes) flattened.push_back(flattened.back() + level / slope);
    for (float& value : values_) {
      if (value >= kUnreachable) continue;
      const auto i = std::min(static_cast<size_t>(value / level), slopes.size() - 1);
      value = static_cast<float>(flattened[i] + (value - i * level) / slopes[i]);
    }
  }

 private:
  double slopeOf(size_t quad) const {
    return std::sqrt(Quad(&values_[quad], grid_.columns).slopeSq()) / grid_.resolution;
  }

  std::vector<double> steepestByLevel(double level) const {
    std::vector<double> slopes(1, 1.0);
    for (const size_t quad : quads_) {
      const float* lower = &values_[quad];
      const float* upper = lower + grid_.columns;
      const auto [low, high] = std::minmax({lower[0], lower[1], upper[0], upper[1]});
      const auto last = static_cast<size_t>(high / level);
      if (last >= slopes.size()) slopes.resize(last + 1, 1.0);
      const double slope = slopeOf(quad);
      for (auto i = static_cast<size_t>(low / level); i <= last; ++i) {
        slopes[i] = std::max(slopes[i], slope);
      }
    }
    return slopes;
  }

  const GridFrame& grid_;
  std::vector<size_t> quads_;
  std::vector<float>& values_;
};

}  // namespace

ShortestWay::ShortestWay(const ClearanceGrid& map, const Point& goal, const Params& params)
    : raster_(map.grid) {
  validate(params);
  const GridFrame grid = frameOf(raster_);
  const double cell = grid.resolution;
  open_clearance_ = leastOpenClearance(params, map.map, cell);
  if (std::isinf(open_clearance_)) return;

  const Point source = betweenCenters(grid, goal);
  SpeedMap speeds = makeSpeedMap(grid, map.clearance, open_clearance_);
  const StaticMap::Obstacles& obstacles = map.map.obstacles();
  if (obstacles.grid) openOffGrid(*obstacles.grid, speeds);
  // A goal near an obstacle may be reached at its tolerance only.
  forEachNear(grid, source, params.goal_tolerance + 2.5 * cell,
              [&](size_t near, double) { speeds.speed[near] = 1.0F; });

  lengths_ = ArrivalTimeField(speeds, source).times();
  Surface surface(grid, openQuads(speeds, lengths_), lengths_);
  surface.flatten();
  slope_ = std::max(1.0, surface.steepest());
  scale_ = static_cast<float>(1.0 / (slope_ * (1.0 + kScaleRounding)));

  offset_ = static_cast<float>(mostNearGoal(grid, source, params.goal_tolerance) + kRounding);
  for (float& length : lengths_) length = length < kUnreachable ? length : 0.0F;
  const auto kept = static_cast<float>(params.clearance);
  is_clear_.reserve(map.clearance.size());
  for (const double clearance : map.clearance) {
    is_clear_.push_back(static_cast<float>(clearance) > kept ? 1 : 0);
  }
}

// With d_i the distances of three centres from the goal and d that of a place between them of
// weights w_i: (sum w_i d_i)^2 <= sum w_i d_i^2 <= d^2 + h^2 / 2.
double ShortestWay::mostNearGoal(const GridFrame& grid, const Point& goal, double radius) const {
  double excess = 0.0;  // of the table over the straight line
  forEachNear(grid, goal, radius + M_SQRT2 * grid.resolution, [&](size_t cell, double distance) {
    excess = std::max(excess, scale_ * lengths_[cell] - distance);
  });
  return std::hypot(radius, M_SQRT1_2 * grid.resolution) + excess;
}

float ShortestWay::lengthFrom(float x, float y) const {
  if (lengths_.empty() || is_clear_[static_cast<size_t>(raster_.cellOf(x, y))] == 0) return 0.0F;
  const float right = (x - raster_.min_x) * raster_.cells_per_meter - 0.5F;
  const float up = (y - raster_.min_y) * raster_.cells_per_meter - 0.5F;
  const float inner_right = std::clamp(right, 0.0F, raster_.last_column);
  const float inner_up = std::clamp(up, 0.0F, raster_.last_row);
  const float column = std::min(std::floor(inner_right), raster_.last_column - 1.0F);
  const float row = std::min(std::floor(inner_up), raster_.last_row - 1.0F);
  const size_t cell = static_cast<size_t>(row) * raster_.columns + static_cast<size_t>(column);
  const Quad quad(&lengths_[cell], raster_.columns);
  return scale_ * quad.at(inner_right - column, inner_up - row) - offset_;
}

}  // namespace pomdp_crowd_nav
