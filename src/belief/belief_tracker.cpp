// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/belief/belief_tracker.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "pomdp_crowd_nav/belief/handover.h"

namespace pomdp_crowd_nav {
namespace {

constexpr double kFirstSpeed = 1.0;     // [m/s], of a person whose velocity is not known yet
constexpr double kFastest = 3.0;        // [m/s], anything faster is two people under one id
constexpr double kSlowest = 0.5;        // [m/s], of a walk; who is slower when new may stand
constexpr double kStampSlack = 1.0e-6;  // [s], rounding in sums and differences of stamps

void require(bool fits, const char* name, const char* expected, double value) {
  if (fits && std::isfinite(value)) return;
  throw std::invalid_argument(fmt::format("belief.{} must {}, got {}", name, expected, value));
}

// Usable tracks by increasing id; of two with the same id, the last one.
std::vector<Track> usableTracks(const std::vector<Track>& tracks) {
  std::vector<Track> usable;
  usable.reserve(tracks.size());
  for (auto track = tracks.rbegin(); track != tracks.rend(); ++track) {
    if (!track->position.allFinite()) continue;
    usable.push_back(*track);
    if (!track->velocity.allFinite()) usable.back().velocity = Point::Zero();
  }
  std::stable_sort(usable.begin(), usable.end(),
                   [](const Track& a, const Track& b) { return a.id < b.id; });
  const auto hasSameId = [](const Track& a, const Track& b) { return a.id == b.id; };
  usable.erase(std::unique(usable.begin(), usable.end(), hasSameId), usable.end());
  return usable;
}

Point slowedDown(const Point& velocity) {
  const double speed = velocity.norm();
  return speed > kFastest ? Point(kFastest / speed * velocity) : velocity;
}

}  // namespace

// One sweep, sorted out.
struct BeliefTracker::Sweep {
  double stamp = 0.0;  // [s]
  std::vector<Known> present, missing;
  std::vector<Track> appeared;
};

BeliefTracker::BeliefTracker(std::vector<Point> destinations, const Params& params)
    : destinations_(std::move(destinations)), params_(params), model_(params.intention) {
  if (destinations_.empty()) throw std::invalid_argument("destinations must not be empty");
  for (const Point& destination : destinations_) {
    if (!destination.allFinite()) throw std::invalid_argument("destinations must be finite");
  }
  require(params.update_period > 0.0, "update_period", "be positive", params.update_period);
  require(params.walking_speed >= 0.0, "walking_speed", "not be negative", params.walking_speed);
  require(params.memory >= 0.0, "memory", "not be negative", params.memory);
  require(params.speed_smoothing > 0.0 && params.speed_smoothing <= 1.0, "speed_smoothing",
          "be in (0, 1]", params.speed_smoothing);
  require(params.inherit_distance >= 0.0, "inherit_distance", "not be negative",
          params.inherit_distance);
}

void BeliefTracker::update(const TrackList& tracks) {
  if (!std::isfinite(tracks.stamp)) return;
  if (tracks.stamp < belief_.stamp) clear();

  Sweep sweep;
  sweep.stamp = tracks.stamp;
  sortOut(tracks, sweep);
  if (params_.inherit_distance > 0.0) handOver(sweep);
  for (const Track& track : sweep.appeared) {
    sweep.present.push_back(newPerson(track, sweep.stamp));
  }
  for (Known& known : sweep.missing) {
    if (remember(sweep.stamp, known)) sweep.present.push_back(std::move(known));
  }
  const auto isBefore = [](const Known& a, const Known& b) { return a.person.id < b.person.id; };
  const auto hasSameId = [](const Known& a, const Known& b) { return a.person.id == b.person.id; };
  if (!std::is_sorted(sweep.present.begin(), sweep.present.end(), isBefore)) {
    std::stable_sort(sweep.present.begin(), sweep.present.end(), isBefore);
  }
  // Who is remembered comes last, and goes where the id is somebody else's now.
  sweep.present.erase(std::unique(sweep.present.begin(), sweep.present.end(), hasSameId),
                      sweep.present.end());
  belief_ = {sweep.stamp, {}};
  belief_.people.reserve(sweep.present.size());
  last_updates_.clear();
  for (Known& known : sweep.present) {
    belief_.people.push_back(std::move(known.person));
    last_updates_.push_back(known.last);
  }
}

// Present is who goes on under an id, missing who was there before, appeared who was not.
void BeliefTracker::sortOut(const TrackList& tracks, Sweep& sweep) {
  const std::vector<Track> usable = usableTracks(tracks.tracks);
  sweep.present.reserve(usable.size() + belief_.people.size());
  auto track = usable.begin();
  for (size_t i = 0; i < belief_.people.size(); ++i) {
    Known known{std::move(belief_.people[i]), last_updates_[i]};
    for (; track != usable.end() && track->id < known.person.id; ++track) {
      sweep.appeared.push_back(*track);
    }
    const bool has_track = track != usable.end() && track->id == known.person.id;
    if (has_track && isSame(*track, sweep.stamp, known.person)) {
      follow(*track, sweep.stamp, known);
      sweep.present.push_back(std::move(known));
      ++track;
    } else {
      sweep.missing.push_back(std::move(known));
    }
  }
  for (; track != usable.end(); ++track) sweep.appeared.push_back(*track);
}

// False where an id has gone farther than anybody runs: it is somebody else's now.
bool BeliefTracker::isSame(const Track& track, double stamp, const PersonBelief& person) const {
  if (params_.inherit_distance <= 0.0) return true;
  const double reach = params_.inherit_distance + kFastest * (stamp - belief_.stamp);
  return (track.position - person.position).norm() <= reach;
}

// Gives who vanished the track that appeared where they should be now.
void BeliefTracker::handOver(Sweep& sweep) const {
  const double longest = std::max(params_.memory, params_.update_period);
  std::vector<Known> vanished;
  std::vector<Point> expected, found;
  for (Known& known : sweep.missing) {
    if (sweep.stamp - known.last.seen > longest) continue;
    expected.push_back(known.person.position +
                       (sweep.stamp - belief_.stamp) * known.person.velocity);
    vanished.push_back(std::move(known));
  }
  for (const Track& track : sweep.appeared) found.push_back(track.position);
  const std::vector<size_t> heirs = matchVanished(expected, found, params_.inherit_distance);

  std::vector<Track> strangers;
  std::vector<bool> is_heard_of(vanished.size());
  for (size_t i = 0; i < sweep.appeared.size(); ++i) {
    if (heirs[i] == kNobody) {
      strangers.push_back(sweep.appeared[i]);
      continue;
    }
    is_heard_of[heirs[i]] = true;
    Known& known = vanished[heirs[i]];
    known.person.id = sweep.appeared[i].id;
    follow(sweep.appeared[i], sweep.stamp, known);
    sweep.present.push_back(std::move(known));
  }
  sweep.appeared = std::move(strangers);
  sweep.missing.clear();
  for (size_t i = 0; i < vanished.size(); ++i) {
    if (!is_heard_of[i]) sweep.missing.push_back(std::move(vanished[i]));
  }
}

// Moves on a person who was not seen; false when it is to be forgotten.
bool BeliefTracker::remember(double stamp, Known& known) const {
  if (params_.memory <= 0.0 || stamp - known.last.seen > params_.memory) return false;
  known.person.position += (stamp - belief_.stamp) * known.person.velocity;
  return true;
}

void BeliefTracker::clear() {
  belief_ = {};
  last_updates_.clear();
}

BeliefTracker::Known BeliefTracker::newPerson(const Track& track, double stamp) const {
  const double seen = std::min(track.velocity.norm(), kFastest);
  double speed = params_.walking_speed;
  if (speed == 0.0) speed = seen > (params_.expect_elsewhere ? kSlowest : 0.0) ? seen : kFirstSpeed;
  const IntentionBelief first = params_.expect_elsewhere ? model_.firstBelief(destinations_.size())
                                                         : IntentionBelief(destinations_.size());
  return {{track.id, track.position, track.velocity, speed, first, slowedDown(track.velocity)},
          {stamp, track.position, stamp, seen > 0.0}};
}

void BeliefTracker::follow(const Track& track, double stamp, Known& known) const {
  PersonBelief& person = known.person;
  person.position = track.position;
  person.velocity = track.velocity;
  known.last.seen = stamp;
  const double elapsed = stamp - known.last.stamp;
  if (elapsed < params_.update_period - kStampSlack) return;

  learnFrom({known.last.position, track.position, elapsed, person.speed, {}}, known);
  known.last = {stamp, track.position, stamp, true};
}

void BeliefTracker::learnFrom(const ObservedWalk& walk, Known& known) const {
  PersonBelief& person = known.person;
  double smoothing = params_.speed_smoothing;
  if (params_.expect_elsewhere) {
    ObservedWalk expected = walk;
    if (known.last.has_walk) expected.velocity = person.walk;
    model_.update(expected, destinations_, person.intention);
    const Point newest = slowedDown((walk.to - walk.from) / walk.duration);
    person.walk += (known.last.has_walk ? smoothing : 1.0) * (newest - person.walk);
    if (person.intention.standing() > 0.5) smoothing = 0.0;  // a stop makes nobody slow
  } else {
    person.intention.update(walk.from, walk.to, destinations_);
  }
  if (params_.walking_speed == 0.0) {
    const double newest = std::min((walk.to - walk.from).norm() / walk.duration, kFastest);
    person.speed += smoothing * (newest - person.speed);
  }
}

}  // namespace pomdp_crowd_nav
