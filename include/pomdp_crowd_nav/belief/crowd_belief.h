// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "pomdp_crowd_nav/belief/intention_belief.h"
#include "pomdp_crowd_nav/world/pedestrian.h"
#include "pomdp_crowd_nav/world/track.h"

namespace pomdp_crowd_nav {

// One visible person: where, how fast, and where to.
struct PersonBelief {
  std::int64_t id = 0;
  Point position{0.0, 0.0};  // [m], newest track
  Point velocity{0.0, 0.0};  // [m/s], of the newest track
  double speed = 1.0;        // [m/s], walking speed to plan with
  IntentionBelief intention;
  Point walk{0.0, 0.0};  // [m/s], smoothed over updates; of a walk elsewhere
};

// Everybody visible at `stamp`, by increasing id.
struct CrowdBelief {
  double stamp = 0.0;  // [s]
  std::vector<PersonBelief> people;
};

// The person as somebody who does what the hypothesis says: who stands has no speed, who walks
// elsewhere a destination far ahead.
Pedestrian walkerOf(const PersonBelief& person, size_t hypothesis,
                    const std::vector<Point>& destinations);

// Everybody of a belief as tracks: those seen and those remembered.
TrackList tracksOf(const CrowdBelief& crowd);

// Moves everybody on for `duration` seconds at the velocity last seen; stamps move along.
void predictPeople(double duration, CrowdBelief& crowd, TrackList& tracks);

}  // namespace pomdp_crowd_nav
