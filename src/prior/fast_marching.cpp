// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/prior/fast_marching.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pomdp_crowd_nav {
namespace {

constexpr float kNever = std::numeric_limits<float>::infinity();

}  // namespace

FastMarching::FastMarching(const std::vector<float>& speed, int columns, int rows,
                           double resolution)
    : columns_(columns),
      rows_(rows),
      stride_(columns + 2 * kFrame),
      resolution_(resolution),
      cells_(static_cast<size_t>(stride_) * (rows + 2 * kFrame), Cell{0.0F, kNever, 0.0F, 0.0F}) {
  const float* next = speed.data();
  for (int row = 0; row < rows; ++row) {
    for (int cell = cellAt(0, row); cell < cellAt(columns, row); ++cell) {
      cells_[cell].crossing_time = static_cast<float>(resolution / *next++);
      cells_[cell].trial_time = kNever;
    }
  }
}

void FastMarching::accept(int column, int row, double time, double path_length) {
  const int cell = cellAt(column, row);
  cells_[cell].time = static_cast<float>(time);
  cells_[cell].path_length = static_cast<float>(path_length);
  cells_[cell].trial_time = 0.0F;
}

void FastMarching::run() {
  for (int row = 0; row < rows_; ++row) {
    for (int cell = cellAt(0, row); cell < cellAt(columns_, row); ++cell) {
      if (cells_[cell].time != kNever) updateNeighbours(cell);
    }
  }
  while (!queue_.isEmpty()) {
    const TrialQueue::Trial earliest = queue_.pop();
    Cell& cell = cells_[earliest.cell];
    if (earliest.time != cell.trial_time) continue;  // improved since, or accepted
    cell.time = earliest.time;
    cell.trial_time = 0.0F;
    updateNeighbours(earliest.cell);
  }
}

void FastMarching::updateNeighbours(int cell) {
  update(cell - 1);
  update(cell + 1);
  update(cell - stride_);
  update(cell + stride_);
}

void FastMarching::update(int cell) {
  if (cells_[cell].trial_time == 0.0F) return;
  const Arrival found = arrival(cell);
  const auto time = static_cast<float>(found.time);
  if (!(time < cells_[cell].trial_time)) return;
  cells_[cell].trial_time = time;
  cells_[cell].path_length = static_cast<float>(pathLength(found, cells_[cell].crossing_time));
  queue_.push({time, cell});
}

// A second-order difference needs a second cell in line that was reached before the first.
FastMarching::Upwind FastMarching::upwind(int cell, int axis_step, bool second_order) const {
  const int step =
      cells_[cell - axis_step].time <= cells_[cell + axis_step].time ? -axis_step : axis_step;
  const double first = cells_[cell + step].time;
  if (first == kNever) return {};
  const double second = cells_[cell + 2 * step].time;
  const double length = cells_[cell + step].path_length;
  if (!second_order || second > first) return {1.0, first, length, first};
  const double second_length = cells_[cell + 2 * step].path_length;
  return {2.25, (4.0 * first - second) / 3.0, (4.0 * length - second_length) / 3.0, first};
}

// The most accurate causal solution: both axes before one, second order before first.
FastMarching::Arrival FastMarching::arrival(int cell) const {
  const double crossing_time = cells_[cell].crossing_time;
  Arrival best{kNever, {}, {}};
  for (const bool second_order : {true, false}) {
    const Upwind x = upwind(cell, 1, second_order);
    const Upwind y = upwind(cell, stride_, second_order);
    if (x.weight > 0.0 && y.weight > 0.0) {
      const Arrival both = solve(x, y, crossing_time);
      if (both.time != kNever) return both;
    }
    for (const Upwind& axis : {x, y}) {
      if (axis.weight == 0.0) continue;
      const Arrival one = solve(axis, {}, crossing_time);
      if (one.time < best.time) best = one;
    }
  }
  return best;
}

// Larger root T of sum weight (T - time)^2 = crossing_time^2.
FastMarching::Arrival FastMarching::solve(const Upwind& x, const Upwind& y, double crossing_time) {
  const double weight = x.weight + y.weight;
  const double lag = y.weight > 0.0 ? y.time - x.time : 0.0;
  const double discriminant =
      weight * crossing_time * crossing_time - x.weight * y.weight * lag * lag;
  if (discriminant < 0.0) return {kNever, x, y};
  const double time = x.time + (y.weight * lag + std::sqrt(discriminant)) / weight;
  if (time < std::max(x.nearest, y.nearest)) return {kNever, x, y};
  return {time, x, y};
}

// The path length l changes along the gradient of T only:
// sum weight (T - time) (l - path_length) = crossing_time * resolution.
double FastMarching::pathLength(const Arrival& arrival, double crossing_time) const {
  const Upwind& x = arrival.x;
  const Upwind& y = arrival.y;
  const double slope_x = x.weight * (arrival.time - x.time);
  const double slope_y = y.weight * (arrival.time - y.time);
  return (crossing_time * resolution_ + slope_x * x.path_length + slope_y * y.path_length) /
         (slope_x + slope_y);
}

std::vector<float> FastMarching::withoutFrame(float Cell::*value) const {
  std::vector<float> inner;
  inner.reserve(static_cast<size_t>(columns_) * rows_);
  for (int row = 0; row < rows_; ++row) {
    for (int cell = cellAt(0, row); cell < cellAt(columns_, row); ++cell) {
      inner.push_back(cells_[cell].*value);
    }
  }
  return inner;
}

}  // namespace pomdp_crowd_nav
