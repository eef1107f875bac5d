// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/belief/belief_tracker.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>
#include <utility>

namespace pomdp_crowd_nav {
namespace {

constexpr double kFirstSpeed = 1.0;     // [m/s], of a person whose velocity is not known yet
constexpr double kFastest = 3.0;        // [m/s], anything faster is two people under one id
constexpr double kStampSlack = 1.0e-6;  // [s], rounding in sums and differences of stamps

void require(bool fits, const char* name, const char* expected, double value) {
  if (fits && std::isfinite(value)) return;
  throw std::invalid_argument(fmt::format("belief.{} must {}, got {}", name, expected, value));
}

// Usable tracks by increasing id; of two with the same id, the last one.
std::map<std::int64_t, Track> usableTracks(const std::vector<Track>& tracks) {
  std::map<std::int64_t, Track> usable;
  for (Track track : tracks) {
    if (!track.position.allFinite()) continue;
    if (!track.velocity.allFinite()) track.velocity = Point::Zero();
    usable[track.id] = track;
  }
  return usable;
}

double firstSpeed(const Track& track) {
  const double speed = track.velocity.norm();
  return speed > 0.0 ? std::min(speed, kFastest) : kFirstSpeed;
}

}  // namespace

BeliefTracker::BeliefTracker(std::vector<Point> destinations, const Params& params)
    : destinations_(std::move(destinations)), params_(params) {
  if (destinations_.empty()) throw std::invalid_argument("destinations must not be empty");
  for (const Point& destination : destinations_) {
    if (!destination.allFinite()) throw std::invalid_argument("destinations must be finite");
  }
  require(params.update_period > 0.0, "update_period", "be positive", params.update_period);
  require(params.walking_speed >= 0.0, "walking_speed", "not be negative", params.walking_speed);
  require(params.memory >= 0.0, "memory", "not be negative", params.memory);
  require(params.speed_smoothing > 0.0 && params.speed_smoothing <= 1.0, "speed_smoothing",
          "be in (0, 1]", params.speed_smoothing);
}

void BeliefTracker::update(const TrackList& tracks) {
  if (!std::isfinite(tracks.stamp)) return;
  if (tracks.stamp < belief_.stamp) clear();

  std::vector<PersonBelief> people;
  std::vector<LastUpdate> last_updates;
  size_t known = 0;  // both lists run by increasing id
  const auto keepUntil = [&](std::int64_t id) {
    for (; known < belief_.people.size() && belief_.people[known].id < id; ++known) {
      if (!remember(tracks.stamp, belief_.people[known], last_updates_[known])) continue;
      people.push_back(std::move(belief_.people[known]));
      last_updates.push_back(last_updates_[known]);
    }
  };
  for (const auto& [id, track] : usableTracks(tracks.tracks)) {
    keepUntil(id);
    if (known < belief_.people.size() && belief_.people[known].id == id) {
      people.push_back(std::move(belief_.people[known]));
      last_updates.push_back(last_updates_[known]);
      ++known;
      follow(track, tracks.stamp, people.back(), last_updates.back());
    } else {
      people.push_back(newPerson(track));
      last_updates.push_back({tracks.stamp, track.position, tracks.stamp});
    }
  }
  keepUntil(std::numeric_limits<std::int64_t>::max());
  belief_ = {tracks.stamp, std::move(people)};
  last_updates_ = std::move(last_updates);
}

// Moves on a person who was not seen; false when it is to be forgotten.
bool BeliefTracker::remember(double stamp, PersonBelief& person, const LastUpdate& last) const {
  if (params_.memory <= 0.0 || stamp - last.seen > params_.memory) return false;
  person.position += (stamp - belief_.stamp) * person.velocity;
  return true;
}

void BeliefTracker::clear() {
  belief_ = {};
  last_updates_.clear();
}

PersonBelief BeliefTracker::newPerson(const Track& track) const {
  const double speed = params_.walking_speed > 0.0 ? params_.walking_speed : firstSpeed(track);
  return {track.id, track.position, track.velocity, speed, IntentionBelief(destinations_.size())};
}

void BeliefTracker::follow(const Track& track, double stamp, PersonBelief& person,
                           LastUpdate& last) const {
  person.position = track.position;
  person.velocity = track.velocity;
  last.seen = stamp;
  const double elapsed = stamp - last.stamp;
  if (elapsed < params_.update_period - kStampSlack) return;

  person.intention.update(last.position, track.position, destinations_);
  if (params_.walking_speed == 0.0) {
    const double walked = (track.position - last.position).norm();
    const double newest = std::min(walked / elapsed, kFastest);
    person.speed += params_.speed_smoothing * (newest - person.speed);
  }
  last = {stamp, track.position, stamp};
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
