// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <optional>

#include "pomdp_crowd_nav/belief/crowd_belief.h"
#include "pomdp_crowd_nav/ros/trail.h"

namespace pomdp_crowd_nav {

// Where everybody was seen in the last seconds, for those who are seen now.
class CrowdTrails {
 public:
  static constexpr double kPeriod = 0.5;  // [s] between two places
  static constexpr size_t kPlaces = 9;    // 4 s; of 1000 people they just fit into one marker

  // Takes note of a crowd that is newer by the period at least; an older one begins afresh.
  void see(const CrowdBelief& crowd);

  const std::map<std::int64_t, Trail>& trails() const { return trails_; }

 private:
  std::optional<double> last_;  // [s], stamp
  std::map<std::int64_t, Trail> trails_;
};

}  // namespace pomdp_crowd_nav
