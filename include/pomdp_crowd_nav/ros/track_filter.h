// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "pomdp_crowd_nav/world/track.h"

namespace pomdp_crowd_nav {

// What a tracker can sensibly say.
struct TrackRange {
  double position = 1.0e6;   // [m], of either coordinate
  double speed = 20.0;       // [m/s], a faster one is not known: zero
  size_t max_people = 1000;  // the nearest to the robot
};

// Tracks that were left out of a sweep, and why.
struct LeftOut {
  unsigned bad = 0;         // no finite position, or one out of range
  unsigned duplicates = 0;  // another track of the sweep had the same id
  unsigned surplus = 0;     // beyond the nearest ones

  void add(const LeftOut& other);
};

// Leaves the usable tracks, by increasing id; of two with one id, the last. While the robot's place
// is not known the first ones are the nearest.
LeftOut filterTracks(const TrackRange& range, const std::optional<Point>& robot, TrackList& list);

}  // namespace pomdp_crowd_nav
