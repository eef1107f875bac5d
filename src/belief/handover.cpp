// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/belief/handover.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace pomdp_crowd_nav {
namespace {

using Cell = std::pair<double, double>;  // whole numbers, of any size

Cell cellOf(const Point& point, double size) {
  return {std::floor(point.x() / size), std::floor(point.y() / size)};
}

struct Place {
  Cell cell;
  size_t index;

  bool operator<(const Place& other) const {
    return std::tie(cell, index) < std::tie(other.cell, other.index);
  }
};

struct Pair {
  double distance_sq;  // [m^2]
  size_t appeared, vanished;

  bool operator<(const Pair& other) const {
    return std::tie(distance_sq, appeared, vanished) <
           std::tie(other.distance_sq, other.appeared, other.vanished);
  }
};

// By cell, the first kCrowded of each.
std::vector<Place> placesOf(const std::vector<Point>& vanished, double size) {
  std::vector<Place> places;
  for (size_t i = 0; i < vanished.size(); ++i) places.push_back({cellOf(vanished[i], size), i});
  std::sort(places.begin(), places.end());
  size_t kept = 0;
  for (size_t i = 0; i < places.size(); ++i) {
    if (kept >= kCrowded && places[kept - kCrowded].cell == places[i].cell) continue;
    places[kept++] = places[i];
  }
  places.resize(kept);
  return places;
}

}  // namespace

std::vector<size_t> matchVanished(const std::vector<Point>& vanished,
                                  const std::vector<Point>& appeared, double distance) {
  const std::vector<Place> places = placesOf(vanished, distance);
  std::vector<Pair> pairs;
  for (size_t i = 0; i < appeared.size(); ++i) {
    const Cell here = cellOf(appeared[i], distance);
    for (const double dx : {-1.0, 0.0, 1.0}) {
      const Cell last{here.first + dx, here.second + 1.0};
      const Place first{{last.first, here.second - 1.0}, 0};
      auto place = std::lower_bound(places.begin(), places.end(), first);
      for (; place != places.end() && place->cell <= last; ++place) {
        const double distance_sq = (vanished[place->index] - appeared[i]).squaredNorm();
        if (distance_sq < distance * distance) pairs.push_back({distance_sq, i, place->index});
      }
    }
  }
  std::sort(pairs.begin(), pairs.end());
  std::vector<size_t> heirs(appeared.size(), kNobody);
  std::vector<bool> taken(vanished.size());
  for (const Pair& pair : pairs) {
    if (heirs[pair.appeared] != kNobody || taken[pair.vanished]) continue;
    heirs[pair.appeared] = pair.vanished;
    taken[pair.vanished] = true;
  }
  return heirs;
}

}  // namespace pomdp_crowd_nav
