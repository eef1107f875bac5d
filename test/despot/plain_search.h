// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pomdp_crowd_nav/despot/search_params.h"

namespace pomdp_crowd_nav {

constexpr long kEnough = 20000;  // trials

// Without regularisation.
inline SearchParams plainSearch(int scenarios, int depth, double discount) {
  SearchParams params;
  params.scenarios = scenarios;
  params.max_depth = depth;
  params.discount = discount;
  params.regularization = 0.0;
  return params;
}

}  // namespace pomdp_crowd_nav
