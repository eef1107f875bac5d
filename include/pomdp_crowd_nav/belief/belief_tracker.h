// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "pomdp_crowd_nav/belief/crowd_belief.h"
#include "pomdp_crowd_nav/belief/intention_model.h"

namespace pomdp_crowd_nav {

// Keeps a belief for every visible track: the first one when new, updated every `update_period`
// from the way walked since the last update. Who is missing from a sweep is moved on at its last
// velocity and forgotten after `memory`, so that a missed detection is no disappearance. A tracker
// may lose somebody and find them again under another id: the new track inherits what is known.
class BeliefTracker {
 public:
  struct Params {
    double update_period = 0.5;  // [s] between two updates of a belief (facts: twice a 1 s step)
    // [m/s], one speed for everybody; 0 to plan with each person's own, smoothed speed.
    double walking_speed = 1.0;
    double speed_smoothing = 0.5;  // weight of the newest speed in (0, 1]
    double memory = 0.0;           // [s] a person is kept unseen; 0: forgotten at once (paper)
    // [m] from where a vanished person should be now, a new track within is that person, and so is
    // one that had another id until now; 0: a new track is a new person (paper)
    double inherit_distance = 0.0;
    // Whether people may stand or walk elsewhere; false: the paper's rule.
    bool expect_elsewhere = false;
    IntentionModel::Params intention;  // where people may stand or walk elsewhere
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
    double seen = 0.0;      // [s], stamp of the newest track
    bool has_walk = false;  // whether person.walk is known
  };
  struct Known {
    PersonBelief person;
    LastUpdate last;
  };
  struct Sweep;

  Known newPerson(const Track& track, double stamp) const;
  void sortOut(const TrackList& tracks, Sweep& sweep);
  void handOver(Sweep& sweep) const;
  bool isSame(const Track& track, double stamp, const PersonBelief& person) const;
  bool remember(double stamp, Known& known) const;
  void follow(const Track& track, double stamp, Known& known) const;
  void learnFrom(const ObservedWalk& walk, Known& known) const;

  std::vector<Point> destinations_;
  Params params_;
  IntentionModel model_;
  CrowdBelief belief_;
  std::vector<LastUpdate> last_updates_;  // parallel to belief_.people
};

}  // namespace pomdp_crowd_nav
