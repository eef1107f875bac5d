// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "pomdp_crowd_nav/belief/crowd_belief.h"
#include "pomdp_crowd_nav/world/static_map.h"

namespace pomdp_crowd_nav {

// C_ped, what an element of a path costs for the people near its end (paper, section LS planner).
//
// Who may be heading anywhere stands in the middle of a potential field of strength / distance.
// Who probably heads for one destination is a disc that walks there: element t is at its end when
// t elements have been driven at `pace`. Who probably stands is a disc that does not move. Nobody
// is touched: the disc of the clearance is infinite, for the uncertain too. Where the path begins
// inside somebody's disc, that disc is as small.
class CrowdCost {
 public:
  struct Params {
    double clearance = 2.0;        // [m], D_ped + L
    double field_strength = 10.0;  // [m], cost 1 m from somebody
    double field_radius = 20.0;    // [m]
    double sure_belief = 0.5;      // probability of a hypothesis from which on somebody is sure
    double pace = 1.0;             // [m/s], of the robot
    bool field_on_way = false;     // who is sure has a field too, which walks along
  };

  explicit CrowdCost(const Params& params) : params_(params) {}

  // Where everybody will be, seen from a path that begins at `start`. Reuses memory.
  void predict(const Point& start, const std::vector<PersonBelief>& people,
               const std::vector<Point>& destinations, const Bounds& bounds);

  // Infinite where somebody is too close.
  double at(double x, double y, int element) const;

 private:
  struct Place {
    double x, y;
  };
  struct Person {
    double clearance_sq;  // [m^2]
    bool has_field;
  };

  Params params_;
  std::vector<Person> people_;
  std::vector<Place> places_;  // element by element
};

// Throws std::invalid_argument naming the first field that is out of range.
void validate(const CrowdCost::Params& params);

}  // namespace pomdp_crowd_nav
