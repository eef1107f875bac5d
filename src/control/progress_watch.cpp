// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/control/progress_watch.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace pomdp_crowd_nav {

ProgressWatch::ProgressWatch(const Params& params) : params_(params) {
  const auto require = [](bool holds, const char* key, const char* range, double value) {
    if (holds) return;
    throw std::invalid_argument(fmt::format("{} must be {}, got {}", key, range, value));
  };
  require(params.distance > 0.0, "progress_distance", "positive", params.distance);
  require(params.blocked_timeout >= 0.0, "blocked_timeout", "at least 0", params.blocked_timeout);
  require(params.abort_timeout >= 0.0, "abort_timeout", "at least 0", params.abort_timeout);
}

void ProgressWatch::begin(double now) {
  since_ = now;
  least_ = -1.0;
}

void ProgressWatch::see(double way, double now) {
  const bool is_first = least_ < 0.0;
  if (!is_first && !(way <= least_ - params_.distance)) return;
  least_ = std::max(0.0, way);
  if (!is_first) since_ = now;
}

void ProgressWatch::hold(double now) { since_ = std::max(since_, now); }

bool ProgressWatch::isBlocked(double now) const {
  return params_.blocked_timeout > 0.0 && stalledFor(now) >= params_.blocked_timeout;
}

bool ProgressWatch::isHopeless(double now) const {
  return params_.abort_timeout > 0.0 && stalledFor(now) >= params_.abort_timeout;
}

}  // namespace pomdp_crowd_nav
