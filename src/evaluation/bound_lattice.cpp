// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/evaluation/bound_lattice.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <queue>

namespace pomdp_crowd_nav {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kRounding = 1e-9;  // [m]

}  // namespace

BoundLattice::BoundLattice(const World& world, const Params& params)
    : params_(params),
      sight_(world.map(), params.obstacle_clearance),
      start_(world.start.position),
      goal_(world.goal) {
  layOut();
  listOffsets();
  measureWays();
}

// Along the beeline, with the start on a node; nodes off the field and in the clearance are left
// out.
void BoundLattice::layOut() {
  const Point way = goal_ - start_;
  along_ = way.norm() > kRounding ? Point(way.normalized()) : Point(1.0, 0.0);
  across_ = {-along_.y(), along_.x()};
  const Bounds& bounds = sight_.map().bounds();
  Eigen::Array2d low = Eigen::Array2d::Constant(kInfinity);
  Eigen::Array2d high = -low;
  for (const double x : {bounds.min.x(), bounds.max.x()}) {
    for (const double y : {bounds.min.y(), bounds.max.y()}) {
      const Point corner = Point(x, y) - start_;
      const Eigen::Array2d turned(corner.dot(along_), corner.dot(across_));
      low = low.min(turned);
      high = high.max(turned);
    }
  }
  const Eigen::Array2d first = (low / params_.spacing).ceil().min(0.0);
  const Eigen::Array2d last = (high / params_.spacing).floor().max(0.0);
  columns_ = static_cast<int>(last.x() - first.x()) + 1;
  rows_ = static_cast<int>(last.y() - first.y()) + 1;
  corner_ = start_ + params_.spacing * (first.x() * along_ + first.y() * across_);
  start_node_ = static_cast<size_t>(-first.y()) * columns_ + static_cast<size_t>(-first.x());
  const auto size = static_cast<size_t>(columns_) * rows_;
  clearances_.assign(size, -1.0F);
  for (size_t node = 0; node < size; ++node) {
    const Point here = place(node);
    const bool is_start = node == start_node_;
    if (!is_start && (!bounds.contains(here) || !sight_.isFree(here))) continue;
    clearances_[node] = static_cast<float>(std::max(0.0, sight_.map().clearance(here)));
  }
}

// One way in each direction.
void BoundLattice::listOffsets() {
  const int reach = params_.reach;
  for (int row = -reach; row <= reach; ++row) {
    for (int column = -reach; column <= reach; ++column) {
      if (std::gcd(row, column) != 1 || row * row + column * column > reach * reach) continue;
      const Point way = params_.spacing * (column * along_ + row * across_);
      offsets_.push_back({column, row, way, way.norm()});
    }
  }
}

// Dijkstra's search from the goal: the exact length of every way that the lattice has without
// people, so that the heuristic of the search among them is consistent.
void BoundLattice::measureWays() {
  using Item = std::pair<double, size_t>;  // length, node
  std::priority_queue<Item, std::vector<Item>, std::greater<Item>> queue;
  ways_.assign(clearances_.size(), kInfinity);
  sees_goal_.assign(clearances_.size(), 0);
  for (size_t node = 0; node < ways_.size(); ++node) {
    if (clearances_[node] < 0.0F) continue;
    const Point here = place(node);
    if (!sight_.isClear(here, arrivalFrom(here))) continue;
    sees_goal_[node] = 1;
    ways_[node] = distanceToGoal(here);
    queue.emplace(ways_[node], node);
  }
  while (!queue.empty()) {
    const auto [length, node] = queue.top();
    queue.pop();
    if (length > ways_[node]) continue;
    for (const Offset& offset : offsets_) {
      const auto other = neighbour(node, offset);
      if (!other || length + offset.length >= ways_[*other] - kRounding) continue;
      if (!isOpen(node, offset, *other)) continue;
      ways_[*other] = length + offset.length;
      queue.emplace(ways_[*other], *other);
    }
  }
}

Point BoundLattice::place(size_t node) const {
  const auto column = static_cast<double>(node % static_cast<size_t>(columns_));
  const auto row = static_cast<double>(node / static_cast<size_t>(columns_));
  return corner_ + params_.spacing * (column * along_ + row * across_);
}

std::optional<size_t> BoundLattice::neighbour(size_t node, const Offset& offset) const {
  const int column = static_cast<int>(node % static_cast<size_t>(columns_)) + offset.columns;
  const int row = static_cast<int>(node / static_cast<size_t>(columns_)) + offset.rows;
  if (column < 0 || row < 0 || column >= columns_ || row >= rows_) return std::nullopt;
  const size_t other = static_cast<size_t>(row) * columns_ + column;
  if (clearances_[other] < 0.0F) return std::nullopt;
  return other;
}

// Far from obstacles nothing needs to be looked at.
bool BoundLattice::isOpen(size_t node, const Offset& offset, size_t other) const {
  const double spare = 0.5 * (clearances_[node] + clearances_[other]) - sight_.clearance();
  if (spare > 0.5 * offset.length) return true;
  return sight_.isClear(place(node), place(other));
}

double BoundLattice::distanceToGoal(const Point& place) const {
  return std::max(0.0, (goal_ - place).norm() - params_.goal_tolerance + kRounding);
}

Point BoundLattice::arrivalFrom(const Point& place) const {
  const double length = (goal_ - place).norm();
  return length > kRounding ? place + (goal_ - place) * (distanceToGoal(place) / length) : place;
}

}  // namespace pomdp_crowd_nav
