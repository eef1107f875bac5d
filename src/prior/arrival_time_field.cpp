// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/prior/arrival_time_field.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "pomdp_crowd_nav/prior/fast_marching.h"

namespace pomdp_crowd_nav {
namespace {

void validate(const SpeedMap& map, const Point& source) {
  const GridFrame& grid = map.grid;
  if (grid.columns < 2 || grid.rows < 2 || map.speed.size() != grid.cellCount()) {
    throw std::invalid_argument(fmt::format("speed map of {} columns by {} rows with {} speeds",
                                            grid.columns, grid.rows, map.speed.size()));
  }
  for (float speed : map.speed) {
    if (speed > 0.0F && std::isfinite(speed)) continue;
    throw std::invalid_argument(fmt::format("speed of a cell must be positive, got {}", speed));
  }
  if (!grid.contains(source)) {
    throw std::invalid_argument(
        fmt::format("source ({}, {}) is off the speed map", source.x(), source.y()));
  }
}

// The cells around a source to which the straight line is the fastest path.
class SourceDisc {
 public:
  SourceDisc(const SpeedMap& map, const Point& source, double radius)
      : map_(map),
        grid_(map.grid),
        source_(source),
        speed_(map.speed[grid_.index(grid_.columnOf(source), grid_.rowOf(source))]),
        radius_(radius) {
    const Point reach(radius, radius);
    first_column_ = grid_.columnOf(source - reach);
    last_column_ = grid_.columnOf(source + reach);
    first_row_ = grid_.rowOf(source - reach);
    last_row_ = grid_.rowOf(source + reach);
    stayShortOfFasterCells();
  }

  void startFrom(FastMarching& march) const {
    const int source_column = grid_.columnOf(source_);
    const int source_row = grid_.rowOf(source_);
    forEachCell([&](int column, int row, double distance) {
      const bool holds_source = column == source_column && row == source_row;
      if (!holds_source && (distance > radius_ || !inSight(grid_.center(column, row)))) return;
      march.accept(column, row, distance / speed_, distance);
    });
  }

 private:
  template <typename Visit>
  void forEachCell(Visit visit) const {
    for (int row = first_row_; row <= last_row_; ++row) {
      for (int column = first_column_; column <= last_column_; ++column) {
        visit(column, row, (grid_.center(column, row) - source_).norm());
      }
    }
  }

  // A detour over faster cells is no shorter than the way to the nearest of them.
  void stayShortOfFasterCells() {
    forEachCell([this](int column, int row, double distance) {
      if (map_.speed[grid_.index(column, row)] > speed_) {
        radius_ = std::min(radius_, distance - grid_.resolution);
      }
    });
  }

  bool inSight(const Point& target) const {
    const Point way = target - source_;
    const int steps = static_cast<int>(std::ceil(2.0 * way.norm() / grid_.resolution));
    for (int i = 0; i <= steps; ++i) {
      const Point point = source_ + static_cast<double>(i) / std::max(1, steps) * way;
      const size_t cell = grid_.index(grid_.columnOf(point), grid_.rowOf(point));
      if (map_.speed[cell] != speed_) return false;
    }
    return true;
  }

  const SpeedMap& map_;
  const GridFrame& grid_;
  Point source_;
  float speed_;
  double radius_;
  int first_column_, last_column_, first_row_, last_row_;
};

}  // namespace

ArrivalTimeField::ArrivalTimeField(const SpeedMap& map, const Point& source, const Params& params)
    : grid_(map.grid), source_(source) {
  validate(map, source);
  FastMarching march(map.speed, grid_.columns, grid_.rows, grid_.resolution);
  SourceDisc(map, source, params.exact_radius).startFrom(march);
  march.run();
  times_ = march.times();
  path_lengths_ = march.pathLengths();
}

}  // namespace pomdp_crowd_nav
