// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pomdp_crowd_nav/params/param_values.h"

namespace pomdp_crowd_nav {

// Parameters that may change while the robot drives have two-ended ranges, because a slider has:
// those of config/parameters.yaml. Throws std::invalid_argument for the first value that is out of
// its range, or no number.
void requireWithinRanges(const ParamValues& values);

}  // namespace pomdp_crowd_nav
