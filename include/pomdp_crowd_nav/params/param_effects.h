// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pomdp_crowd_nav/params/load_params.h"

namespace pomdp_crowd_nav {

// Whether a change of parameters asks for another planner.
bool concernsPlanner(const NavigationParams& from, const NavigationParams& to);

// Whether it changes what a planner knows of map and goal, so that tables cannot be shared.
bool concernsTables(const NavigationParams& from, const NavigationParams& to);

}  // namespace pomdp_crowd_nav
