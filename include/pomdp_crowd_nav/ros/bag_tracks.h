// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "pomdp_crowd_nav/sim/tracks_file.h"

namespace pomdp_crowd_nav {

struct BagSource {
  std::string path;
  // Of TrackedPersons, ours or spencer's, or of People, ours or people_msgs'; "/" in front or not.
  std::string topic = "tracked_persons";
  std::string frame = "map";  // in which the tracks are wanted
};

struct BagTracks {
  std::vector<TrackSample> samples;  // in order of time, each person once at a time
  std::size_t messages = 0;
  std::size_t left_out = 0;  // of these: the bag has no transform at their time
};

// The tracks of a bag, brought into the frame by the transforms that the bag holds; `progress` is
// told how many of how many messages are read. Throws std::runtime_error with one line that names
// the file: for a file that is no bag, a topic without such messages, a frame from which no
// transform leads to the one that is wanted, and no track at all.
BagTracks readTracksBag(const BagSource& source,
                        const std::function<void(size_t, size_t)>& progress);

}  // namespace pomdp_crowd_nav
