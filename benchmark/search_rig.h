// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "pomdp_crowd_nav/planner/planner.h"
#include "pomdp_crowd_nav/world/static_map.h"

namespace pomdp_crowd_nav {

// The decision that all search benchmarks time: an empty field of 100 m by 100 m, a robot at rest
// at (1, 25) that faces east, its goal at (100, 75), and people 3 m to 15 m away of whom nothing
// is known but that each walks to one of the four corners. One-second steps, the paper's rewards.
struct SearchRigParams {
  int pedestrians = 6;  // about the robot, and all of them attended
  int scenarios = 100;  // K
  int depth = 100;      // D, steps of 1 s
  int threads = 1;
  UpperBoundKind upper_bound = UpperBoundKind::kTight;
  bool bold_rollouts = true;
};

StaticMap rigMap();
Point rigGoal();
std::vector<Point> rigDestinations();
PlannerParams rigPlannerParams(const SearchRigParams& params);

// The planner 2d_fmm on that field; one serves many decisions.
std::unique_ptr<Planner> makeRigPlanner(const SearchRigParams& params);

// The robot and one crowd; the same seed gives the same people.
Situation rigSituation(int pedestrians, std::uint64_t seed);

}  // namespace pomdp_crowd_nav
