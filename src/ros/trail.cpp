// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/ros/trail.h"

namespace pomdp_crowd_nav {

void Trail::extend(const Point& place) {
  if (!place.allFinite()) return;
  if (!places_.empty()) {
    const double way = (place - places_.back()).norm();
    if (way < params_.spacing) return;
    if (way > params_.jump) places_.clear();
  }
  places_.push_back(place);
  if (places_.size() > params_.places) places_.pop_front();
}

}  // namespace pomdp_crowd_nav
