// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <memory>
#include <vector>

#include "pomdp_crowd_nav/sim/simulator.h"

namespace pomdp_crowd_nav {

// Where everybody of an episode will be, by time: simulated ahead as far as it is asked for. People
// walk straight within a tick. Not thread-safe.
class CrowdHistory {
 public:
  CrowdHistory(const World& world, const Simulator::Params& params);

  // Whether somebody who drives straight on from `from` at `velocity` [m/s], from time `begin` on
  // for `duration` [s], keeps `distance` [m] from everybody.
  bool isClear(const Point& from, const Point& velocity, double begin, double duration,
               double distance);

 private:
  // What a person does in a tick.
  struct Walk {
    Point from{0.0, 0.0};
    Point to{0.0, 0.0};
  };
  // Everybody in a tick, sorted into square cells by where they end.
  struct Tick {
    std::vector<Walk> walks;
    std::vector<int> first;  // index of the first walk of each cell, and of the end
  };

  const Tick& tick(size_t index);
  void simulateTick();
  int columnOf(double x) const;
  int rowOf(double y) const;

  Simulator simulator_;
  Bounds bounds_;
  int columns_;
  int rows_;
  std::map<std::int64_t, Point> last_;  // by id
  std::vector<Tick> ticks_;             // tick i ends at (i + 1) kTick
};

}  // namespace pomdp_crowd_nav
