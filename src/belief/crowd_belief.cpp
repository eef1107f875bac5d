// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/belief/crowd_belief.h"

namespace pomdp_crowd_nav {
namespace {

constexpr double kFarAhead = 1000.0;  // [m], farther than anybody walks within a horizon

}  // namespace

Pedestrian walkerOf(const PersonBelief& person, size_t hypothesis,
                    const std::vector<Point>& destinations) {
  const Point& here = person.position;
  if (hypothesis == IntentionBelief::kStanding) return {here, here, 0.0};
  if (hypothesis != IntentionBelief::kElsewhere) {
    return {here, destinations[hypothesis], person.speed};
  }
  const double speed = person.walk.norm();
  if (speed <= 0.0) return {here, here, 0.0};
  return {here, here + kFarAhead / speed * person.walk, speed};
}

TrackList tracksOf(const CrowdBelief& crowd) {
  TrackList tracks;
  tracks.stamp = crowd.stamp;
  for (const PersonBelief& person : crowd.people) {
    tracks.tracks.push_back({person.id, person.position, person.velocity});
  }
  return tracks;
}

void predictPeople(double duration, CrowdBelief& crowd, TrackList& tracks) {
  for (PersonBelief& person : crowd.people) person.position += duration * person.velocity;
  for (Track& track : tracks.tracks) track.position += duration * track.velocity;
  crowd.stamp += duration;
  tracks.stamp += duration;
}

}  // namespace pomdp_crowd_nav
