// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "pomdp_crowd_nav/sim/tracks_file.h"

namespace pomdp_crowd_nav {

// Where recorded people come from and go to.
struct LearnedDestination {
  Point position{0.0, 0.0};  // [m], mean of the ends of walks that belong to it
  int people = 0;            // who begin or end their walk there
};

// What was found in a recording.
struct LearnedDestinations {
  std::vector<LearnedDestination> destinations;  // by decreasing number of people
  int walks = 0;                                 // long enough to be looked at
  int ends = 0;                                  // beginnings and ends not cut off by the recording
  int ends_near = 0;                             // of these, who belong to a destination
};

// What counts as a walk and as a destination.
struct LearningParams {
  double merge_distance = 2.0;  // [m], ends this close to a destination belong to it
  int min_people = 5;           // of a destination
  double min_walk = 3.0;  // [m], from the beginning to the end of a walk; shorter do not count
  double at_edge = 1.0;   // [s], from beginning or end of the recording; cut off there
};

// Mean shift: from everywhere where walks begin or end up to the densest place about, whose ends
// within `merge_distance` are a destination's. Without chance; time is bounded by the area that
// the ends take up, not by their number. Throws std::invalid_argument for a parameter out of range.
LearnedDestinations learnDestinations(const std::vector<TrackSample>& recording,
                                      const LearningParams& params);

// The file for `rosparam load` and for world files: a list `destinations`.
std::string toYaml(const LearnedDestinations& learned);

}  // namespace pomdp_crowd_nav
