// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "pomdp_crowd_nav/world/geometry.h"

namespace pomdp_crowd_nav {

// A simulated person as it really is; no part of the planner sees this type.
struct Walker {
  std::int64_t id = 0;
  Point position{0.0, 0.0};  // [m]
};

// What every generated crowd may need; each takes its part.
struct CrowdParams {
  int pedestrians = 100;
  // How the place along an edge is drawn. false: with the draw that chose the edge, as in the
  // authors' code, so that each edge has one busy quarter; true: with a draw of its own.
  bool uniform_respawn = false;
  std::uint64_t seed = 1;
};

// The people outside the robot. They do not react to it, so a crowd is a function of its seed and
// the time alone: every planner of one experiment meets exactly the same people.
class Crowd {
 public:
  static constexpr double kTick = 0.1;  // [s]

  virtual ~Crowd() = default;

  // Moves everybody on by one tick of kTick seconds.
  virtual void tick() = 0;

  // Where everybody really is now; people who arrived or left are not in the list.
  virtual const std::vector<Walker>& walkers() const = 0;

  // Where a sensor last saw everybody: at or before now, never interpolated from what comes later.
  virtual const std::vector<Walker>& sighted() const { return walkers(); }

  // Age of `sighted` [s].
  virtual double sightingAge() const { return 0.0; }
};

}  // namespace pomdp_crowd_nav
