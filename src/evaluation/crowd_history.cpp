// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/evaluation/crowd_history.h"

#include <algorithm>
#include <cmath>

namespace pomdp_crowd_nav {
namespace {

constexpr double kCell = 4.0;       // [m]
constexpr double kLongWalk = 0.5;   // [m], nobody walks farther in a tick
constexpr double kRounding = 1e-9;  // [m], [s]

std::map<std::int64_t, Point> placesOf(const std::vector<Walker>& walkers) {
  std::map<std::int64_t, Point> places;
  for (const Walker& walker : walkers) places[walker.id] = walker.position;
  return places;
}

}  // namespace

CrowdHistory::CrowdHistory(const World& world, const Simulator::Params& params)
    : simulator_(world, params),
      bounds_(world.bounds),
      columns_(std::max(1, static_cast<int>((bounds_.max - bounds_.min).x() / kCell) + 1)),
      rows_(std::max(1, static_cast<int>((bounds_.max - bounds_.min).y() / kCell) + 1)),
      last_(placesOf(simulator_.crowd().walkers())) {}

int CrowdHistory::columnOf(double x) const {
  return std::clamp(static_cast<int>(std::floor((x - bounds_.min.x()) / kCell)), 0, columns_ - 1);
}

int CrowdHistory::rowOf(double y) const {
  return std::clamp(static_cast<int>(std::floor((y - bounds_.min.y()) / kCell)), 0, rows_ - 1);
}

void CrowdHistory::simulateTick() {
  simulator_.advance(Crowd::kTick);
  const std::vector<Walker>& walkers = simulator_.crowd().walkers();
  const auto cellOf = [&](const Point& place) {
    return static_cast<size_t>(rowOf(place.y()) * columns_ + columnOf(place.x()));
  };
  Tick tick;
  tick.first.assign(static_cast<size_t>(rows_ * columns_) + 1, 0);
  for (const Walker& walker : walkers) ++tick.first[cellOf(walker.position) + 1];
  for (size_t cell = 1; cell < tick.first.size(); ++cell) tick.first[cell] += tick.first[cell - 1];
  std::vector<int> next = tick.first;
  tick.walks.resize(walkers.size());
  for (const Walker& walker : walkers) {
    const auto last = last_.find(walker.id);
    const Point& from = last == last_.end() ? walker.position : last->second;
    // Who leaps, as recordings may have it, is in the new place at once.
    const bool walks = (walker.position - from).norm() <= kLongWalk;
    tick.walks[next[cellOf(walker.position)]++] = {walks ? from : walker.position, walker.position};
  }
  last_ = placesOf(walkers);
  ticks_.push_back(std::move(tick));
}

const CrowdHistory::Tick& CrowdHistory::tick(size_t index) {
  while (ticks_.size() <= index) simulateTick();
  return ticks_[index];
}

bool CrowdHistory::isClear(const Point& from, const Point& velocity, double begin, double duration,
                           double distance) {
  const double end = begin + duration;
  const double reach = distance + kLongWalk;
  const double squared_distance = (distance - kRounding) * (distance - kRounding);
  double now = begin;
  auto index = static_cast<size_t>(std::floor(begin / Crowd::kTick + kRounding));
  while (now < end - kRounding) {
    const double tick_begin = static_cast<double>(index) * Crowd::kTick;
    const double until = std::min(end, tick_begin + Crowd::kTick);
    const Point here = from + velocity * (now - begin);
    const Point there = from + velocity * (until - begin);
    const double share_now = std::clamp((now - tick_begin) / Crowd::kTick, 0.0, 1.0);
    const double share_until = std::clamp((until - tick_begin) / Crowd::kTick, 0.0, 1.0);
    const Tick& people = tick(index);
    const Point low = here.cwiseMin(there) - Point::Constant(reach);
    const Point high = here.cwiseMax(there) + Point::Constant(reach);
    const int last_column = columnOf(high.x());
    for (int row = rowOf(low.y()); row <= rowOf(high.y()); ++row) {
      const int first_cell = row * columns_ + columnOf(low.x());
      const int last_cell = row * columns_ + last_column;
      for (int i = people.first[first_cell]; i < people.first[last_cell + 1]; ++i) {
        const Walk& walk = people.walks[i];
        const Point step = walk.to - walk.from;
        // As seen from the person, the way is straight too.
        const Point a = here - (walk.from + share_now * step);
        const Point b = there - (walk.from + share_until * step);
        const Point way = b - a;
        const double squared = way.squaredNorm();
        const double nearest = squared > 0.0 ? std::clamp(-a.dot(way) / squared, 0.0, 1.0) : 0.0;
        if ((a + nearest * way).squaredNorm() < squared_distance) return false;
      }
    }
    now = until;
    ++index;
  }
  return true;
}

}  // namespace pomdp_crowd_nav
