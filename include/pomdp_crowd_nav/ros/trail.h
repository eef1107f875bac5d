// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <deque>

#include "pomdp_crowd_nav/world/geometry.h"

namespace pomdp_crowd_nav {

// Where somebody was, the oldest place first. As many places as it holds are kept; one that nobody
// gets to from the one before begins a new trail.
class Trail {
 public:
  struct Params {
    size_t places = 2;
    double spacing = 0.0;  // [m], at least, between two places
    double jump = 3.0;     // [m], farther apart two places do not belong together
  };

  explicit Trail(const Params& params) : params_(params) {}

  void extend(const Point& place);
  const std::deque<Point>& places() const { return places_; }

 private:
  Params params_;
  std::deque<Point> places_;
};

}  // namespace pomdp_crowd_nav
