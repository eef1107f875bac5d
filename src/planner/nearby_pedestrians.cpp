// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/planner/nearby_pedestrians.h"

#include <algorithm>
#include <cmath>

namespace pomdp_crowd_nav {

std::vector<PersonBelief> nearbyPedestrians(const CrowdBelief& crowd, const VehicleState& vehicle,
                                            const AttentionParams& params) {
  struct Candidate {
    double distance;
    const PersonBelief* person;
  };
  std::vector<Candidate> candidates;
  for (const PersonBelief& person : crowd.people) {
    const double distance = (person.position - vehicle.position).norm();
    const double angle = wrapAngle(bearing(vehicle.position, person.position) - vehicle.heading);
    if (std::abs(angle) > params.half_angle && distance > params.close_range) continue;
    const Point soon = person.position + params.lookahead * person.velocity -
                       (vehicle.position + params.lookahead * vehicle.velocity());
    candidates.push_back({std::min(distance, soon.norm()), &person});
  }
  const size_t count = std::min(candidates.size(), static_cast<size_t>(params.pedestrians));
  std::partial_sort(candidates.begin(), candidates.begin() + count, candidates.end(),
                    [](const Candidate& a, const Candidate& b) {
                      if (a.distance != b.distance) return a.distance < b.distance;
                      return a.person->id < b.person->id;
                    });
  candidates.resize(count);
  std::sort(candidates.begin(), candidates.end(),
            [](const Candidate& a, const Candidate& b) { return a.person->id < b.person->id; });
  std::vector<PersonBelief> nearby;
  for (const Candidate& candidate : candidates) nearby.push_back(*candidate.person);
  return nearby;
}

}  // namespace pomdp_crowd_nav
