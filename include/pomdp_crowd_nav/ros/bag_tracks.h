// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "pomdp_crowd_nav/sim/tracks_file.h"

namespace pomdp_crowd_nav {

struct BagSource {
  std::string path;
  std::string topic =
      "tracked_persons";      // of TrackedPersons, ours or spencer's; "/" in front or not
  std::string frame = "map";  // of all messages: nothing is transformed
};

// The tracks of a bag in order of time, each person once at a time; `progress` is told how many of
// how many messages are read. Throws std::runtime_error with one line that names the file: for a
// file that is no bag, a topic without such messages, another frame, and no track at all.
std::vector<TrackSample> readTracksBag(const BagSource& source,
                                       const std::function<void(size_t, size_t)>& progress);

}  // namespace pomdp_crowd_nav
