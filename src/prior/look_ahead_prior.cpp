// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/prior/look_ahead_prior.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace pomdp_crowd_nav {
namespace {

constexpr double kStride = 0.25;  // [m], of the walk along the path

}  // namespace

LookAheadPrior::LookAheadPrior(std::shared_ptr<const RolloutPrior> path, double distance)
    : path_(std::move(path)), distance_(distance) {
  if (distance >= 0.0 && std::isfinite(distance)) return;
  throw std::invalid_argument(
      fmt::format("prior.look_ahead must not be negative, got {}", distance));
}

std::optional<double> LookAheadPrior::directionAt(const Pose& pose) const {
  const std::optional<double> here = path_->directionAt(pose);
  if (!here || (goal() - pose.position).norm() <= kStride) return here;
  Pose ahead = pose;
  for (double left = distance_; left > 0.0; left -= kStride) {
    const std::optional<double> direction = path_->directionAt(ahead);
    if (!direction) break;
    const double to_goal = (goal() - ahead.position).norm();
    if (to_goal <= kStride) {
      ahead.position = goal();
      break;
    }
    ahead.position += std::min(left, kStride) * unitVector(*direction);
    ahead.heading = *direction;
  }
  const bool has_moved = (ahead.position - pose.position).norm() > 0.5 * kStride;
  return has_moved ? bearing(pose.position, ahead.position) : *here;
}

}  // namespace pomdp_crowd_nav
