// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pomdp_crowd_nav/world/static_map.h"

namespace pomdp_crowd_nav {

// Whether straight ways keep their distance from the obstacles of a map.
//
// An end of a way may lie inside the clearance, as a goal beside a wall does. Such a way is clear
// if it leaves the margin steadily: its clearance rises from that of the end by kLeastRise per
// metre until it is the full one.
class LineOfSight {
 public:
  static constexpr double kLeastRise = 0.2;

  // `clearance` [m], at least a few centimetres are kept.
  LineOfSight(StaticMap map, double clearance);

  const StaticMap& map() const { return map_; }
  double clearance() const { return clearance_; }  // [m]

  // Whether a place keeps the clearance; `shortfall` [m] is overlooked.
  bool isFree(const Point& place, double shortfall = 0.0) const {
    return map_.clearance(place) >= clearance_ - shortfall;
  }

  bool isClear(const Point& from, const Point& to) const { return isClear(from, to, kLeastRise); }
  bool isClear(const Point& from, const Point& to, double least_rise) const;

  // What isClear says from every point of a disc that is free but for kShortfall: the same of each,
  // or not known.
  static constexpr double kShortfall = 0.05;  // [m]
  enum class View { kClear, kBlocked, kUncertain };
  View viewFrom(const Circle& disc, const Point& to) const;

 private:
  StaticMap map_;
  double clearance_;
};

}  // namespace pomdp_crowd_nav
