// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <visualization_msgs/MarkerArray.h>

#include <cstdint>
#include <vector>

#include "pomdp_crowd_nav/belief/crowd_belief.h"
#include "pomdp_crowd_nav/ros/crowd_trails.h"

namespace pomdp_crowd_nav {

struct BeliefScene {
  const CrowdBelief& crowd;
  const std::vector<Point>& destinations;     // [m]
  const std::vector<std::int64_t>& attended;  // ids
  const CrowdTrails& trails;
  Point robot{0.0, 0.0};      // [m]
  std::int64_t blocker = -1;  // id, -1: nobody blocks the way
  double symbol_size = 0.5;   // [m], see markers.h
};

// People in the colour of the most likely destination, the paler the less sure; arrows toward
// each destination that is likely enough, as wide as it is likely; where they were seen, older
// places paler; rings around those whose futures are searched, with a stroke all the way to their
// destinations; and who blocks the way. As markers.h says of all arrays; of very many people those
// whose futures are searched and the nearest to the robot are drawn first.
visualization_msgs::MarkerArray beliefMarkers(const BeliefScene& scene,
                                              const std_msgs::Header& header);

}  // namespace pomdp_crowd_nav
