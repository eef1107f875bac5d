// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/params/param_ranges.h"

#include <fmt/format.h>

#include <stdexcept>

namespace pomdp_crowd_nav {
namespace {

struct Range {
  const char* key;
  double lowest;
  double highest;
};

constexpr double kMostCost = -1e5;

constexpr Range kRanges[] = {
    {"search_time", 0.01, 10.0},
    {"attended_pedestrians", 0, 64},
    {"model/pedestrian_distance", 0.0, 10.0},
    {"model/obstacle_distance", 0.0, 10.0},
    {"model/near_distance", 0.0, 50.0},
    {"model/far_distance", 0.0, 50.0},
    {"model/bold_distance", 0.0, 50.0},
    {"reward/goal", 1.0, 1e5},
    {"reward/pedestrian", kMostCost, 0.0},
    {"reward/obstacle", kMostCost, 0.0},
    {"reward/sudden_brake", kMostCost, 0.0},
    {"reward/time", kMostCost, 0.0},
    {"reward/low_speed", kMostCost, 0.0},
    {"search/scenarios", 1, 5000},
    {"search/regularization", 0.0, 10.0},
    {"search/target_gap", 0.0, 0.99},
    {"prior/extra_clearance", 0.0, 5.0},
    {"emergency/decision_distance", 0.0, 10.0},
    {"emergency/reflex_distance", 0.0, 10.0},
    {"emergency/reaction_time", 0.0, 2.0},
    {"display/tree_depth", 1, 200},
};

double toNumber(const ParamValue& value) {
  const int* integer = std::get_if<int>(&value);
  return integer ? *integer : std::get<double>(value);
}

}  // namespace

void requireWithinRanges(const ParamValues& values) {
  for (const Range& range : kRanges) {
    const double value = toNumber(values.at(range.key));
    if (value >= range.lowest && value <= range.highest) continue;
    throw std::invalid_argument(fmt::format("{} must be between {} and {}, got {}", range.key,
                                            range.lowest, range.highest, value));
  }
}

}  // namespace pomdp_crowd_nav
