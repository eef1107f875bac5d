// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/path/crowd_cost.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace pomdp_crowd_nav {
namespace {

constexpr int kElements = 256;     // later ones read the last: people have arrived by then
constexpr double kGiveWay = 1e-3;  // [m], by which a disc is smaller than the distance at the start

void require(bool fits, const char* name, const char* expected, double value) {
  if (fits) return;
  throw std::invalid_argument(fmt::format("path/{} must be {}, got {}", name, expected, value));
}

// After a straight walk to a destination that ends there.
Point walked(const Point& from, const Point& destination, double distance) {
  const Point way = destination - from;
  const double length = way.norm();
  return length <= distance ? destination : Point(from + distance / length * way);
}

}  // namespace

void validate(const CrowdCost::Params& p) {
  require(p.field_strength >= 0.0, "field_strength", "at least 0", p.field_strength);
  require(p.field_radius >= 0.0, "field_radius", "at least 0", p.field_radius);
  require(p.sure_belief >= 0.0, "sure_belief", "at least 0", p.sure_belief);
  require(p.pace > 0.0, "pace", "positive", p.pace);
}

void CrowdCost::predict(const Point& start, const std::vector<PersonBelief>& people,
                        const std::vector<Point>& destinations, const Bounds& bounds) {
  const size_t count = people.size();
  people_.resize(count);
  places_.resize(count * (kElements + 1));
  for (size_t i = 0; i < count; ++i) {
    const PersonBelief& person = people[i];
    const size_t likely = person.intention.mostLikely();
    const bool sure = person.intention.probability(likely) >= params_.sure_belief;
    const Pedestrian walker = walkerOf(person, likely, destinations);
    const double speed = sure ? walker.speed / params_.pace : 0.0;  // [m per element]
    for (int t = 0; t <= kElements; ++t) {
      const Point place = walked(walker.position, walker.destination, speed * t);
      const Point inside = place.cwiseMax(bounds.min).cwiseMin(bounds.max);
      places_[static_cast<size_t>(t) * count + i] = {inside.x(), inside.y()};
    }
    const double free = (person.position - start).norm() - kGiveWay;
    const double kept = std::max(0.0, std::min(params_.clearance, free));
    people_[i] = {kept * kept, !sure || params_.field_on_way};
  }
}

double CrowdCost::at(double x, double y, int element) const {
  const size_t count = people_.size();
  const Place* places = places_.data() + static_cast<size_t>(std::min(element, kElements)) * count;
  const double radius_sq = params_.field_radius * params_.field_radius;
  double cost = 0.0;
  for (size_t i = 0; i < count; ++i) {
    const double dx = x - places[i].x;
    const double dy = y - places[i].y;
    const double distance_sq = dx * dx + dy * dy;
    if (distance_sq <= people_[i].clearance_sq) return std::numeric_limits<double>::infinity();
    if (people_[i].has_field && distance_sq < radius_sq) {
      cost += params_.field_strength / std::sqrt(distance_sq);
    }
  }
  return cost;
}

}  // namespace pomdp_crowd_nav
