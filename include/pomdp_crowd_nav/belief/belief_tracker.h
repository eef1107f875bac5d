// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "pomdp_crowd_nav/belief/intention_belief.h"
#include "pomdp_crowd_nav/world/track.h"

namespace pomdp_crowd_nav {

// One visible person: where, how fast, and where to.
struct PersonBelief {
  std::int64_t id = 0;
  Point position{0.0, 0.0};  // [m], newest track
  Point velocity{0.0, 0.0};  // [m/s], of the newest track
  double speed = 1.0;        // [m/s], walking speed to plan with
  IntentionBelief intention;
};

// Everybody visible at `stamp`, by increasing id.
struct CrowdBelief {
  double stamp = 0.0;  // [s]
  std::vector<PersonBelief> people;
};

// Everybody of a belief as tracks: those seen and those remembered.
TrackList tracksOf(const CrowdBelief& crowd);

// Moves everybody on for `duration` seconds at the velocity last seen; stamps move along.
void predictPeople(double duration, CrowdBelief& crowd, TrackList& tracks);

// Keeps a belief for every visible track: uniform when new, updated every `update_period` from the
// progress made since the last update. Who is missing from a sweep is moved on at its last velocity
// and forgotten after `memory`, so that a missed detection is no disappearance.
class BeliefTracker {
 public:
  struct Params {
    double update_period = 0.5;  // [s] between two updates of a belief (facts: twice a 1 s step)
    // [m/s], one speed for everybody; 0 to plan with each person's own, smoothed speed.
    double walking_speed = 1.0;
    double speed_smoothing = 0.5;  // weight of the newest speed in (0, 1]
    double memory = 0.0;           // [s] a person is kept unseen; 0: forgotten at once (paper)
  };

  // Throws std::invalid_argument without destinations or with a parameter out of range.
  BeliefTracker(std::vector<Point> destinations, const Params& params);

  // Tracks that are not in the list are kept for `memory`. A stamp older than the last one clears
  // all beliefs first (the clock jumped back); the same stamp again changes positions only. Tracks
  // without a finite position do not count, of two with one id the last does.
  void update(const TrackList& tracks);
  void clear();

  const CrowdBelief& belief() const { return belief_; }
  const std::vector<Point>& destinations() const { return destinations_; }

 private:
  struct LastUpdate {
    double stamp = 0.0;
    Point position{0.0, 0.0};
    double seen = 0.0;  // [s], stamp of the newest track
  };

  PersonBelief newPerson(const Track& track) const;
  bool remember(double stamp, PersonBelief& person, const LastUpdate& last) const;
  void follow(const Track& track, double stamp, PersonBelief& person, LastUpdate& last) const;

  std::vector<Point> destinations_;
  Params params_;
  CrowdBelief belief_;
  std::vector<LastUpdate> last_updates_;  // parallel to belief_.people
};

}  // namespace pomdp_crowd_nav
