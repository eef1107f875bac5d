// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>

#include "pomdp_crowd_nav/control/blocking_person.h"
#include "pomdp_crowd_nav/control/emergency_override.h"
#include "pomdp_crowd_nav/params/load_params.h"

namespace pomdp_crowd_nav {

// The inputs at the start of a search.
struct Snapshot {
  Situation situation;  // predicted to the moment at which the decision takes effect
  TrackList tracks;     // predicted
  Pose robot;           // as measured
  long stop_count = 0;  // of the executor
};

// What is made of them.
struct Verdict {
  Decision decision;
  std::optional<std::int64_t> in_the_way;  // id of the nearest person there
  bool stands = false;                     // the robot, and stays where it is
  double way = 0.0;                        // [m], left to the goal
};

// One decision: the planner's, unless the emergency override replaces it.
class DecisionMaker {
 public:
  explicit DecisionMaker(const NavigationParams& params);

  Verdict decide(const Snapshot& snapshot, const SearchLimit& limit, Planner& planner) const;

 private:
  EmergencyOverride emergency_;
  BlockingPerson blocking_person_;
};

}  // namespace pomdp_crowd_nav
