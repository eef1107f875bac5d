// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "pomdp_crowd_nav/prior/prior_factory.h"
#include "pomdp_crowd_nav/prior/roadmap.h"
#include "pomdp_crowd_nav/prior/rollout_prior.h"
#include "pomdp_crowd_nav/prior/sight_index.h"
#include "pomdp_crowd_nav/prior/way_out.h"

namespace pomdp_crowd_nav {

// The roadmap of a map, shared by the priors of all goals: the one made last is kept. Thread-safe.
std::shared_ptr<const Roadmap> roadmapOf(const StaticMap& map, const PriorParams& params);

// Paths over a roadmap: toward the milestone in sight over which the way to the goal is shortest,
// or toward the goal itself once that is in sight. So a path leaves a milestone as soon as one
// farther along comes into sight; the authors' memory of the milestone passed is not needed. From
// inside the clearance it leads to the nearest place outside and on from there.
class RoadmapPrior : public RolloutPrior {
 public:
  // Throws std::invalid_argument on parameters out of range or a goal out of sight of the roadmap.
  RoadmapPrior(const StaticMap& map, const Point& goal, const PriorParams& params);
  RoadmapPrior(std::shared_ptr<const Roadmap> roadmap, const Point& goal);

  const Point& goal() const override { return goal_; }
  std::optional<double> directionAt(const Pose& pose) const override;
  double distanceToGoal(const Point& position) const override;
  Course courseAt(const Pose& pose) const override;

  const std::shared_ptr<const Roadmap>& roadmap() const { return roadmap_; }

  // Where paths may head: the goal, then the milestones with a way to it.
  const std::vector<Waypoint>& waypoints() const { return index_.waypoints(); }

 private:
  struct Way {
    Point target{0.0, 0.0};  // [m], to head for
    double length = 0.0;     // [m], to the goal
  };

  std::optional<Way> wayFrom(const Point& position) const;
  std::optional<Way> wayOutFrom(const Point& position) const;

  std::shared_ptr<const Roadmap> roadmap_;
  Point goal_;
  SightIndex index_;
  bool goal_is_free_;
};

}  // namespace pomdp_crowd_nav
