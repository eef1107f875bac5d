// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/control/blocking_person.h"

namespace pomdp_crowd_nav {
namespace {

constexpr double kSoon = 2.0;  // [s], a person who crosses the way by then is in it
constexpr int kMoments = 4;    // at which that is looked at, beside now

template <class Counts>
std::optional<std::int64_t> nearest(const Point& robot, const TrackList& tracks, Counts counts) {
  const Track* found = nullptr;
  double least = 0.0;
  for (const Track& track : tracks.tracks) {
    const double distance = (track.position - robot).norm();
    if (!counts(track, distance) || (found != nullptr && distance >= least)) continue;
    found = &track;
    least = distance;
  }
  return found != nullptr ? std::optional<std::int64_t>(found->id) : std::nullopt;
}

}  // namespace

std::optional<std::int64_t> BlockingPerson::find(const Point& robot,
                                                 const std::optional<double>& direction,
                                                 const TrackList& tracks) const {
  const auto close = nearest(robot, tracks, [&](const Track&, double distance) {
    return distance <= params_.decision_distance;
  });
  if (close || !direction) return close;
  const Point end = robot + params_.look_ahead * unitVector(*direction);
  return nearest(robot, tracks,
                 [&](const Track& track, double) { return isInTheWay(track, robot, end); });
}

bool BlockingPerson::isInTheWay(const Track& track, const Point& robot, const Point& end) const {
  for (int i = 0; i <= kMoments; ++i) {
    const Point place = track.position + i * (kSoon / kMoments) * track.velocity;
    if (distanceToSegment(place, robot, end) <= params_.clearance) return true;
  }
  return false;
}

}  // namespace pomdp_crowd_nav
