// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/sim/corner_crowd.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "pomdp_crowd_nav/sim/random_draws.h"

namespace pomdp_crowd_nav {
namespace {

constexpr double kStride = 0.1;          // [m] in a tick, 1 m/s
constexpr double kStrideNoise = 0.05;    // [m], half width of the uniform noise on a stride
constexpr double kArrival = 1.0;         // [m], somebody this near has arrived
constexpr double kStartExclusion = 5.0;  // [m], nobody starts this near to the robot
constexpr double kEdgeExclusion = 15.0;  // [m], nobody appears this near to its start or goal
constexpr int kTicksBetweenRespawns = 10;
constexpr int kMaxDraws = 1000;  // on a field too small for the exclusions, the last one counts

// A whole number of metres from the lower end of [min, max].
double wholeMetres(double min, double max, double uniform) {
  return min + std::floor((max - min) * uniform);
}

}  // namespace

CornerCrowd::CornerCrowd(const World& world, const Params& params)
    : bounds_(world.bounds),
      start_(world.start.position),
      goal_(world.goal),
      all_destinations_(world.destinations),
      params_(params),
      random_(params.seed) {
  if (all_destinations_.empty()) throw std::invalid_argument("destinations must not be empty");
  const Point center = 0.5 * (bounds_.min + bounds_.max);
  for (const Point& destination : all_destinations_) {
    if (destination.x() > center.x()) opposite_destinations_[kLeft].push_back(destination);
    if (destination.y() < center.y()) opposite_destinations_[kTop].push_back(destination);
    if (destination.x() < center.x()) opposite_destinations_[kRight].push_back(destination);
    if (destination.y() > center.y()) opposite_destinations_[kBottom].push_back(destination);
  }
  for (auto& choices : opposite_destinations_) {
    if (choices.empty()) choices = all_destinations_;
  }
  for (int i = 0; i < params_.pedestrians; ++i) addAnywhere();
}

void CornerCrowd::tick() {
  removeArrived();
  for (size_t i = 0; i < walkers_.size(); ++i) walk(walkers_[i].position, destinations_[i]);
  if (++ticks_ % kTicksBetweenRespawns != 0) return;
  while (walkers_.size() < static_cast<size_t>(params_.pedestrians)) addAtEdge();
}

void CornerCrowd::addAnywhere() {
  Point position;
  Point destination;
  for (int i = 0; i < kMaxDraws; ++i) {
    position.x() = wholeMetres(bounds_.min.x(), bounds_.max.x(), drawUniform(random_));
    position.y() = wholeMetres(bounds_.min.y(), bounds_.max.y(), drawUniform(random_));
    destination = drawFrom(all_destinations_);
    if ((position - start_).norm() > kStartExclusion) break;
  }
  add(position, destination);
}

void CornerCrowd::addAtEdge() {
  const double draw = drawUniform(random_);
  const auto side = static_cast<Side>(static_cast<int>(4.0 * draw));
  Point position = pointOnEdge(side, params_.uniform_respawn ? drawUniform(random_) : draw);
  for (int i = 0; i < kMaxDraws && isTooClose(side, position); ++i) {
    position = pointOnEdge(side, drawUniform(random_));
  }
  add(position, drawFrom(opposite_destinations_[side]));
}

void CornerCrowd::add(const Point& position, const Point& destination) {
  walkers_.push_back({next_id_++, position});
  destinations_.push_back(destination);
}

void CornerCrowd::removeArrived() {
  size_t kept = 0;
  for (size_t i = 0; i < walkers_.size(); ++i) {
    if ((destinations_[i] - walkers_[i].position).norm() <= kArrival) continue;
    walkers_[kept] = walkers_[i];
    destinations_[kept++] = destinations_[i];
  }
  walkers_.resize(kept);
  destinations_.resize(kept);
}

void CornerCrowd::walk(Point& position, const Point& destination) {
  const double stride = kStride + kStrideNoise * (2.0 * drawUniform(random_) - 1.0);
  position += stride * (destination - position).normalized();
  position = position.cwiseMax(bounds_.min).cwiseMin(bounds_.max).eval();
}

Point CornerCrowd::pointOnEdge(Side side, double uniform) const {
  if (side == kLeft || side == kRight) {
    const double x = side == kLeft ? bounds_.min.x() : bounds_.max.x();
    return {x, wholeMetres(bounds_.min.y(), bounds_.max.y(), uniform)};
  }
  const double y = side == kBottom ? bounds_.min.y() : bounds_.max.y();
  return {wholeMetres(bounds_.min.x(), bounds_.max.x(), uniform), y};
}

bool CornerCrowd::isTooClose(Side side, const Point& position) const {
  const bool at_start = (position - start_).norm() <= kEdgeExclusion;
  const bool at_goal = (position - goal_).norm() <= kEdgeExclusion;
  // The authors' code asks for both at the left edge, which never happens.
  if (side == kLeft && !params_.uniform_respawn) return at_start && at_goal;
  return at_start || at_goal;
}

const Point& CornerCrowd::drawFrom(const std::vector<Point>& choices) {
  return choices[static_cast<size_t>(drawUniform(random_) * static_cast<double>(choices.size()))];
}

}  // namespace pomdp_crowd_nav
