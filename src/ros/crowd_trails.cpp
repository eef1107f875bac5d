// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/ros/crowd_trails.h"

#include <utility>

namespace pomdp_crowd_nav {
namespace {

constexpr double kRounding = 1e-6;  // [s]

}  // namespace

void CrowdTrails::see(const CrowdBelief& crowd) {
  if (last_ && crowd.stamp < *last_) trails_.clear();
  const bool is_older = last_ && crowd.stamp < *last_;
  if (last_ && !is_older && crowd.stamp - *last_ < kPeriod - kRounding) return;
  last_ = crowd.stamp;
  std::map<std::int64_t, Trail> present;
  for (const PersonBelief& person : crowd.people) {
    const auto known = trails_.find(person.id);
    Trail trail = known != trails_.end() ? std::move(known->second) : Trail({kPlaces});
    trail.extend(person.position);
    present.emplace(person.id, std::move(trail));
  }
  trails_ = std::move(present);
}

}  // namespace pomdp_crowd_nav
