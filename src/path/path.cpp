// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/path/path.h"

#include <algorithm>
#include <cmath>

namespace pomdp_crowd_nav {
namespace {

constexpr double kNegligible = 1e-9;  // [m], no leg is as short
constexpr double kSpacing = 0.01;     // [m], of the places that are compared

// A leg without its first `distance` metres.
PathLeg rest(const PathLeg& leg, double distance) {
  const double share = distance / leg.length;
  return {leg.headingAt(distance), leg.turn * (1.0 - share), leg.length - distance};
}

}  // namespace

Path::Path(const Point& start, std::vector<PathLeg> legs) : legs_(std::move(legs)) {
  Point position = start;
  double length = 0.0;
  for (const PathLeg& leg : legs_) {
    starts_.push_back(position);
    begins_.push_back(length);
    position += leg.displacement(leg.length);
    length += leg.length;
  }
  starts_.push_back(position);
  begins_.push_back(length);
}

size_t Path::legAt(double distance) const {
  const auto next = std::upper_bound(begins_.begin(), begins_.end(), distance);
  const auto count = static_cast<size_t>(next - begins_.begin());
  return std::min(count == 0 ? 0 : count - 1, legs_.size() - 1);
}

Point Path::positionAt(double distance) const {
  if (isEmpty()) return starts_.empty() ? Point(0.0, 0.0) : starts_.front();
  if (distance >= length()) return starts_.back();
  const size_t leg = legAt(distance);
  return starts_[leg] + legs_[leg].displacement(std::max(0.0, distance - begins_[leg]));
}

double Path::headingAt(double distance) const {
  if (isEmpty()) return 0.0;
  const size_t leg = legAt(distance);
  return legs_[leg].headingAt(std::clamp(distance - begins_[leg], 0.0, legs_[leg].length));
}

std::vector<PathLeg> Path::firstLegs(double distance) const {
  std::vector<PathLeg> first;
  double left = distance;
  for (const PathLeg& leg : legs_) {
    if (left <= kNegligible) break;
    const double driven = std::min(left, leg.length);
    first.push_back({leg.heading, leg.turn * driven / leg.length, driven});
    left -= driven;
  }
  return first;
}

Path Path::from(double distance) const {
  if (isEmpty()) return *this;
  std::vector<PathLeg> legs;
  for (size_t i = legAt(distance); i < legs_.size(); ++i) {
    const double driven = std::max(0.0, distance - begins_[i]);
    if (driven < legs_[i].length - kNegligible) legs.push_back(rest(legs_[i], driven));
  }
  return Path(positionAt(distance), std::move(legs));
}

double Path::nearestTo(const Point& place, double within) const {
  const double end = std::min(within, length());
  const int count = static_cast<int>(std::ceil(end / kSpacing));
  double best = 0.0;
  double nearest = (positionAt(0.0) - place).squaredNorm();
  for (int i = 1; i <= count; ++i) {
    const double here = std::min(end, i * kSpacing);
    const double distance = (positionAt(here) - place).squaredNorm();
    if (distance >= nearest) continue;
    nearest = distance;
    best = here;
  }
  return best;
}

}  // namespace pomdp_crowd_nav
