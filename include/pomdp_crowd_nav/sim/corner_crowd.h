// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <random>
#include <vector>

#include "pomdp_crowd_nav/sim/crowd.h"
#include "pomdp_crowd_nav/sim/world_file.h"

namespace pomdp_crowd_nav {

// The paper's crowd: people start anywhere and walk straight to a corner of the field, through
// each other and through obstacles (facts sheet, section 1). Once a second everybody who arrived
// is replaced by somebody new at an edge, who walks to a destination in the opposite half.
class CornerCrowd : public Crowd {
 public:
  using Params = CrowdParams;

  // Throws std::invalid_argument when the world has no destinations.
  CornerCrowd(const World& world, const Params& params);

  void tick() override;
  const std::vector<Walker>& walkers() const override { return walkers_; }

  // Where each of `walkers` is going.
  const std::vector<Point>& destinations() const { return destinations_; }

 private:
  enum Side { kLeft, kTop, kRight, kBottom };

  void addAnywhere();
  void addAtEdge();
  void add(const Point& position, const Point& destination);
  void removeArrived();
  void walk(Point& position, const Point& destination);

  Point pointOnEdge(Side side, double uniform) const;
  bool isTooClose(Side side, const Point& position) const;
  const Point& drawFrom(const std::vector<Point>& choices);

  Bounds bounds_;
  Point start_;  // [m], of the robot
  Point goal_;   // [m], of the robot
  std::vector<Point> all_destinations_;
  std::array<std::vector<Point>, 4> opposite_destinations_;  // by side
  Params params_;
  std::mt19937_64 random_;

  std::vector<Walker> walkers_;
  std::vector<Point> destinations_;  // parallel to walkers_
  std::int64_t next_id_ = 1;
  long ticks_ = 0;
};

}  // namespace pomdp_crowd_nav
