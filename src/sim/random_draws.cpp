// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/sim/random_draws.h"

#include <cmath>

namespace pomdp_crowd_nav {

double drawUniform(std::mt19937_64& random) {
  return std::ldexp(static_cast<double>(random() >> 11), -53);
}

// Box and Muller's transform; its second value is not used.
double drawNormal(std::mt19937_64& random) {
  constexpr double kFullTurn = 6.283185307179586;
  const double radius = std::sqrt(-2.0 * std::log(1.0 - drawUniform(random)));
  return radius * std::cos(kFullTurn * drawUniform(random));
}

}  // namespace pomdp_crowd_nav
