// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/planner/planner.h"

#include <fmt/format.h>

#include <stdexcept>

namespace pomdp_crowd_nav {

void validate(const PlannerParams& params) {
  validate(params.model);
  validate(params.search);
  if (params.pedestrians < 0 || params.pedestrians > 64) {
    throw std::invalid_argument(
        fmt::format("attended_pedestrians must be between 0 and 64, got {}", params.pedestrians));
  }
  if (!(params.attention_lookahead >= 0.0 && params.attention_lookahead <= 10.0)) {
    throw std::invalid_argument(fmt::format("attention_lookahead must be in [0, 10] s, got {}",
                                            params.attention_lookahead));
  }
  if (!(params.attention_angle > 0.0 && params.attention_angle <= 3.2)) {
    throw std::invalid_argument(
        fmt::format("attention_angle must be in (0, pi] rad, got {}", params.attention_angle));
  }
}

}  // namespace pomdp_crowd_nav
