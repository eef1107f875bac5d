// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <random>

namespace pomdp_crowd_nav {

// Draws that are the same with every standard library; std::uniform_real_distribution and
// std::normal_distribution are not.

double drawUniform(std::mt19937_64& random);  // in [0, 1)
double drawNormal(std::mt19937_64& random);   // mean 0, standard deviation 1

}  // namespace pomdp_crowd_nav
