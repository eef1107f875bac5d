// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/prior/line_of_sight.h"

#include <algorithm>
#include <utility>

namespace pomdp_crowd_nav {
namespace {

// Clearance changes by at most the way between two points, so a march may stride by what a point
// has to spare. It takes no shorter strides than this, and so overlooks dips of half of it at a
// sharp corner, of 0.1 mm along a round one.
constexpr double kLeastStride = 0.05;  // [m]
constexpr double kRounding = 1e-9;     // [m]

}  // namespace

LineOfSight::LineOfSight(StaticMap map, double clearance)
    : map_(std::move(map)), clearance_(std::max(clearance, kLeastStride)) {}

// From `to`, so that a point farther along a clear way finds the same points clear.
bool LineOfSight::isClear(const Point& from, const Point& to, double least_rise) const {
  const double length = (from - to).norm();
  const Point direction = (from - to) / std::max(length, kRounding);
  const double at_from = map_.clearance(from);
  const double at_to = map_.clearance(to);
  for (double way = 0.0; way < length;) {
    const double here = map_.clearance(to + way * direction);
    const double asked =
        std::min({clearance_, at_to + least_rise * way, at_from + least_rise * (length - way)});
    if (here < asked - kRounding) return false;
    way += std::max(here - clearance_, kLeastStride);
  }
  return true;
}

// Ways from the disc run beside the one from its centre, at most `width` away from it.
LineOfSight::View LineOfSight::viewFrom(const Circle& disc, const Point& to) const {
  const double length = (disc.center - to).norm();
  if (length <= disc.radius) return View::kUncertain;
  const Point direction = (disc.center - to) / length;
  const double widening = disc.radius / length;
  const double least_rise = kLeastRise * (1.0 - widening);
  const double at_to = map_.clearance(to);
  bool clear = isFree(disc.center, -disc.radius);
  for (double way = 0.0; way < length;) {
    const double here = map_.clearance(to + way * direction);
    const double width = widening * way;
    const double asked =
        std::min(clearance_, at_to + least_rise * way) - kShortfall - 2.0 * kLeastStride;
    if (here + width < asked) return View::kBlocked;
    const double all_clear = (here - width - clearance_) / (1.0 + widening);
    clear = clear && all_clear > kLeastStride;
    way += clear ? all_clear : std::max(here + width - asked, kLeastStride);
  }
  return clear ? View::kClear : View::kUncertain;
}

}  // namespace pomdp_crowd_nav
