// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/planner/planner.h"

#include <fmt/format.h>

#include <stdexcept>

namespace pomdp_crowd_nav {

void validate(const LimitedSpaceParams& params) {
  validate(params.path);
  if (!(params.pace >= 0.0)) {
    throw std::invalid_argument(fmt::format("path/pace must be at least 0, got {}", params.pace));
  }
  if (!(params.time_share > 0.0 && params.time_share < 1.0)) {
    throw std::invalid_argument(
        fmt::format("path/time_share must be in (0, 1), got {}", params.time_share));
  }
  if (params.max_expansions < 1) {
    throw std::invalid_argument(
        fmt::format("path/max_expansions must be at least 1, got {}", params.max_expansions));
  }
  if (!(params.pedestrian_noise >= 0.0)) {
    throw std::invalid_argument(
        fmt::format("path/pedestrian_noise must be at least 0, got {}", params.pedestrian_noise));
  }
}

void validate(const PlannerParams& params) {
  validate(params.model);
  validate(params.search);
  validate(params.limited_space);
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
