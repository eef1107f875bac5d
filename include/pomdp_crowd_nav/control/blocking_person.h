// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>

#include "pomdp_crowd_nav/world/geometry.h"
#include "pomdp_crowd_nav/world/track.h"

namespace pomdp_crowd_nav {

// Says for whom a robot at rest waits.
class BlockingPerson {
 public:
  struct Params {
    double decision_distance = 2.0;  // [m], who is nearer keeps the robot at rest
    double clearance = 2.0;          // [m], between robot and person, centre to centre
    double look_ahead = 4.0;         // [m], of the way on that must be clear
  };

  explicit BlockingPerson(const Params& params) : params_(params) {}

  // Id of the nearest person within the decision distance; without one there, of the nearest who
  // is, or is about to be, in the way in `direction` [rad]. Nothing when it waits for nobody, and
  // for the way where no direction is known.
  std::optional<std::int64_t> find(const Point& robot, const std::optional<double>& direction,
                                   const TrackList& tracks) const;

 private:
  bool isInTheWay(const Track& track, const Point& robot, const Point& end) const;

  Params params_;
};

}  // namespace pomdp_crowd_nav
