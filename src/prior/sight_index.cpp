// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/prior/sight_index.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace pomdp_crowd_nav {
namespace {

constexpr size_t kCandidatesPerLeaf = 12;
constexpr double kHere = 1e-6;      // [m], closer than this one stands on a waypoint
constexpr double kRounding = 1e-9;  // [m]
constexpr double kInfinity = std::numeric_limits<double>::infinity();

int quadrantOf(const Point& position, const Point& center) {
  return (position.x() > center.x() ? 1 : 0) + (position.y() > center.y() ? 2 : 0);
}

}  // namespace

SightIndex::Square SightIndex::Square::quarter(int quadrant) const {
  const double quarter_side = 0.5 * half_side;
  return {center + Point((quadrant & 1) != 0 ? quarter_side : -quarter_side,
                         (quadrant & 2) != 0 ? quarter_side : -quarter_side),
          quarter_side};
}

SightIndex::SightIndex(const LineOfSight& sight, std::vector<Waypoint> waypoints)
    : sight_(sight),
      waypoints_(std::move(waypoints)),
      smallest_side_(std::max(0.8, 0.25 * sight.clearance())) {
  const Bounds& bounds = sight_.map().bounds();
  root_ = {0.5 * (bounds.min + bounds.max), 0.5 * (bounds.max - bounds.min).maxCoeff()};
  nodes_.resize(1);
  nodes_[0].candidates.resize(waypoints_.size());
  std::iota(nodes_[0].candidates.begin(), nodes_[0].candidates.end(), 0);
  split(0, root_);
}

double SightIndex::wayOver(int waypoint, const Point& from) const {
  return (waypoints_[waypoint].position - from).norm() + waypoints_[waypoint].distance_to_goal;
}

// Says no only when that is certain.
bool SightIndex::hasFreePlaces(const Square& square) const {
  const Bounds& bounds = sight_.map().bounds();
  const Point half = Point::Constant(square.half_side);
  const bool on_map = (square.center + half - bounds.min).minCoeff() >= 0.0 &&
                      (bounds.max - square.center + half).minCoeff() >= 0.0;
  return on_map &&
         sight_.isFree(square.center, M_SQRT2 * square.half_side + LineOfSight::kShortfall);
}

void SightIndex::split(int node, const Square& square) {
  nodes_[node].candidates = narrowed(nodes_[node].candidates, square);
  if (nodes_[node].candidates.size() <= kCandidatesPerLeaf) return;
  if (2.0 * square.half_side <= smallest_side_) return;
  const int first_child = static_cast<int>(nodes_.size());
  nodes_.resize(nodes_.size() + 4);
  nodes_[node].first_child = first_child;
  const std::vector<int> candidates = std::move(nodes_[node].candidates);
  for (int quadrant = 0; quadrant < 4; ++quadrant) {
    const Square quarter = square.quarter(quadrant);
    if (!hasFreePlaces(quarter)) continue;
    nodes_[first_child + quadrant].candidates = candidates;
    split(first_child + quadrant, quarter);
  }
}

// Nearest way first, which leaves little to look at after a waypoint in sight.
std::vector<int> SightIndex::narrowed(const std::vector<int>& candidates,
                                      const Square& square) const {
  const Circle disc{square.center, M_SQRT2 * square.half_side};
  std::vector<std::pair<double, int>> ways;
  for (const int candidate : candidates) {
    ways.emplace_back(wayOver(candidate, square.center), candidate);
  }
  std::sort(ways.begin(), ways.end());
  std::vector<int> kept;
  double longest_best = kInfinity;  // no point of the square has a longer way
  for (const auto& [way, candidate] : ways) {
    if (way - disc.radius > longest_best + kRounding) break;
    const auto view = sight_.viewFrom(disc, waypoints_[candidate].position);
    if (view == LineOfSight::View::kBlocked) continue;
    kept.push_back(candidate);
    if (view == LineOfSight::View::kClear) {
      longest_best = std::min(longest_best, way + disc.radius);
    }
  }
  return kept;
}

int SightIndex::leafAt(const Point& position) const {
  int node = 0;
  Square square = root_;
  while (nodes_[node].first_child >= 0) {
    const int quadrant = quadrantOf(position, square.center);
    node = nodes_[node].first_child + quadrant;
    square = square.quarter(quadrant);
  }
  return node;
}

std::optional<int> SightIndex::bestFrom(const Point& position) const {
  if (!sight_.map().bounds().contains(position)) return std::nullopt;
  if (!sight_.isFree(position, LineOfSight::kShortfall)) return std::nullopt;
  std::optional<int> best;
  double shortest = kInfinity;
  for (const int candidate : nodes_[leafAt(position)].candidates) {
    const Waypoint& waypoint = waypoints_[candidate];
    const double way = wayOver(candidate, position);
    if (way >= shortest) continue;
    if (way - waypoint.distance_to_goal < kHere && waypoint.distance_to_goal > 0.0) continue;
    if (!sight_.isClear(position, waypoint.position)) continue;
    best = candidate;
    shortest = way;
  }
  return best;
}

}  // namespace pomdp_crowd_nav
