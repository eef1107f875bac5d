// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "pomdp_crowd_nav/prior/line_of_sight.h"
#include "pomdp_crowd_nav/prior/way_out.h"

namespace pomdp_crowd_nav {

// Random places of a map, its milestones, and straight ways between neighbours that keep clear of
// obstacles (Kavraki et al. 1996; paper, section on Probabilistic Roadmaps). Knows no goal: made
// once per map, used for every goal. The same parameters make the same roadmap.
class Roadmap {
 public:
  struct Params {
    int milestones = 1000;   // N_prm; fewer where there is no room for more
    int neighbours = 10;     // k, nearest earlier milestones to which a new one is joined
    double spacing = 2.0;    // [m], between any two milestones
    double clearance = 3.3;  // [m], of milestones and edges
    int seed = 11;           // of the milestones
  };
  struct Edge {
    int from = 0;         // index of a milestone
    int to = 0;           // index of a milestone
    double length = 0.0;  // [m]
  };

  // Throws std::invalid_argument on parameters out of range.
  Roadmap(const StaticMap& map, const Params& params);
  Roadmap(const Roadmap&) = delete;
  Roadmap& operator=(const Roadmap&) = delete;

  const std::vector<Point>& milestones() const { return milestones_; }
  const std::vector<Edge>& edges() const { return edges_; }
  const LineOfSight& sight() const { return sight_; }
  const WayOut& wayOut() const { return way_out_; }

  // Length of the shortest path over the edges to a goal, per milestone [m]; infinite where there
  // is none. The goal is joined to the `neighbours` nearest milestones in sight of it. Throws
  // std::invalid_argument naming the goal when there is none.
  std::vector<double> distancesTo(const Point& goal) const;

  // Whether a roadmap of this map with these parameters would be the same.
  bool isOf(const StaticMap& map, const Params& params) const;

 private:
  std::vector<Edge> waysTo(const Point& goal) const;
  void joinComponents();

  Params params_;
  LineOfSight sight_;  // to which the table of ways out refers: no copies
  WayOut way_out_;
  std::vector<Point> milestones_;
  std::vector<Edge> edges_;
};

}  // namespace pomdp_crowd_nav
