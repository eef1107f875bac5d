// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "pomdp_crowd_nav/prior/clearance_grid.h"
#include "pomdp_crowd_nav/prior/rollout_prior.h"
#include "pomdp_crowd_nav/world/static_map.h"

namespace pomdp_crowd_nav {

// What every prior may need; each takes its part.
struct PriorParams {
  double resolution = 0.2;  // [m], cell of the fast marching grid and of the navigation field
  double clearance = 3.0;   // [m], paths keep this far from obstacles where they can
  // [m], paths keep a little more, so that straight steps along them stay outside `clearance`
  double extra_clearance = 0.3;
  double robot_radius = 1.0;  // [m], what must fit through a passage
  // Speed of the front inside the clearance as a share of its free speed, in (0, 1): low enough
  // to go round, above zero so that a robot that got inside is led out. A band of width w is cut
  // through where the way round is longer by more than w / blocked_speed.
  double blocked_speed = 0.01;
  // The same where there is less than that clearance, but room for the robot: a door that leaves
  // less than is wanted is taken where the way round is longer by more than its depth /
  // narrow_speed. At least blocked_speed, at most 1.
  double narrow_speed = 0.1;
  // [m] from obstacles, where the front of Fast Marching Square is at full speed
  double saturation_distance = 10.0;
  double look_ahead = 4.0;         // [m] along the path, of a car that steers by it
  int milestones = 1000;           // N_prm, of the roadmap; fewer where there is no room
  int neighbours = 10;             // k, nearest milestones to which each one is joined
  double milestone_spacing = 2.0;  // [m], at least so far apart
  int seed = 11;                   // of the milestones
};

// Names that makePrior knows.
std::vector<std::string> priorNames();

// Builds the prior `name`, one of priorNames(), for a map and a goal.
// Throws std::invalid_argument for an unknown name (listing the known), a parameter out of range,
// or a goal that is off the map, inside an obstacle or out of sight of the roadmap.
std::shared_ptr<const RolloutPrior> makePrior(const std::string& name, const StaticMap& map,
                                              const Point& goal, const PriorParams& params);

// The same with the map's share of the work done; `clearances` at the resolution of `params`.
std::shared_ptr<const RolloutPrior> makePrior(const std::string& name,
                                              const ClearanceGrid& clearances, const Point& goal,
                                              const PriorParams& params);

}  // namespace pomdp_crowd_nav
