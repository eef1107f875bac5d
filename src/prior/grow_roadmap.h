// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "pomdp_crowd_nav/prior/roadmap.h"

namespace pomdp_crowd_nav {

struct GrownRoadmap {
  std::vector<Point> milestones;
  std::vector<Roadmap::Edge> edges;
};

// Grows a roadmap with OMPL's PRM; the one place that knows OMPL. Ends early when 100 draws for
// each milestone have not found room for all of them.
GrownRoadmap growRoadmap(const LineOfSight& sight, const Roadmap::Params& params);

}  // namespace pomdp_crowd_nav
