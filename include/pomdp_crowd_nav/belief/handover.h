// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "pomdp_crowd_nav/world/geometry.h"

namespace pomdp_crowd_nav {

constexpr size_t kNobody = static_cast<size_t>(-1);

// For everybody who appeared, the index of who vanished there, or kNobody: pairs closer than
// `distance` [m], the nearest first, each person once; of equal pairs the one of lower indices.
// n log n in the number of people: in a square of the size of `distance` only the first kCrowded
// who vanished count, more are not people.
std::vector<size_t> matchVanished(const std::vector<Point>& vanished,
                                  const std::vector<Point>& appeared, double distance);

constexpr size_t kCrowded = 16;

}  // namespace pomdp_crowd_nav
