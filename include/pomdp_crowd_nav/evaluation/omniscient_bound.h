// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "pomdp_crowd_nav/evaluation/bound_lattice.h"
#include "pomdp_crowd_nav/evaluation/crowd_history.h"

namespace pomdp_crowd_nav {

// The fastest trip of a robot that knows where everybody will be.
//
// It drives at full speed, which it takes at once and in any direction, or it rests; while it
// drives it keeps its distance from everybody and from obstacles. At rest it is never unsafe, by
// the paper's rule, so that it may wait anywhere and nothing is gained by arriving later: an A*
// search over places with their earliest arrival, where each way is taken as soon as it is clear.
// Places are those of a lattice along the line from start to goal; from each of them ways lead in
// many directions, and straight to the goal.
//
// The plan that is found can be driven, so the best one is no slower; a trip off the lattice or at
// other speeds may in principle be faster. None is faster than the drive without people. Of the
// paper's robot it counts the step at rest in which an episode begins and what the first speeding
// up costs, but not that after a rest, nor that trips end at whole steps; of a car not the radius
// of its turns.
class OmniscientBound {
 public:
  struct Params {
    double max_speed = 2.0;           // [m/s], v_max
    double start_delay = 1.5;         // [s], at rest at the start
    double person_distance = 1.0;     // [m], kept from everybody while driving (paper: unsafe)
    double obstacle_clearance = 3.0;  // [m]
    double goal_tolerance = 1.0;      // [m], D_g
    double time_limit = 300.0;        // [s]
    double spacing = 0.5;             // [m], of the lattice
    int reach = 8;                    // longest way, in spacings
    double wait = 0.1;                // [s], departures are put off by multiples of this
    bool pull_straight = true;        // whether the plan leaves out places that it can pass by
  };
  struct Leg {
    Point from{0.0, 0.0};
    Point to{0.0, 0.0};
    double departure = 0.0;  // [s], after waiting at `from`
    double arrival = 0.0;    // [s]
  };
  struct Plan {
    std::vector<Leg> legs;
    double arrival = 0.0;  // [s]
  };

  // Throws std::invalid_argument for a parameter out of range.
  OmniscientBound(const World& world, const Params& params);

  // The earliest arrival that was found; nothing within the time limit. Thread-safe.
  std::optional<Plan> plan(CrowdHistory& people) const;

  // A lower limit [s]: the drive straight to the goal if nobody and nothing were there.
  double beelineTime() const;
  // What the plan takes without people [s], infinite where there is no way.
  double emptyDriveTime() const;

 private:
  class Search;

  bool isClear(const Point& from, const Point& to, double departure, CrowdHistory& people) const;
  Plan pulledStraight(const Plan& plan, CrowdHistory& people) const;
  std::optional<Leg> earliestLeg(const Point& from, const Point& to, double ready,
                                 double latest_arrival, CrowdHistory& people) const;

  Params params_;
  BoundLattice lattice_;
};

}  // namespace pomdp_crowd_nav
