// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "pomdp_crowd_nav/world/geometry.h"

namespace pomdp_crowd_nav {

// What a prior says at a place.
struct Course {
  Point direction{0.0, 0.0};  // unit vector, (0, 0) where no path leads to the goal
  double distance = 0.0;      // [m] along the path, infinite where there is none
};

// "How would I go from here if nobody were in the way?" Answers for one map and one goal.
//
// Implementations are immutable once built and thread-safe; they keep no memory of past queries.
class RolloutPrior {
 public:
  virtual ~RolloutPrior() = default;

  virtual const Point& goal() const = 0;

  // Direction of travel to take at a pose [rad]; nothing where no path leads to the goal.
  virtual std::optional<double> directionAt(const Pose& pose) const = 0;

  // Length of the path from here to the goal [m]; infinite where there is none.
  virtual double distanceToGoal(const Point& position) const = 0;

  // Both at once, as tables of a whole map ask for them. To override where that is cheaper.
  virtual Course courseAt(const Pose& pose) const {
    const std::optional<double> direction = directionAt(pose);
    return {direction ? unitVector(*direction) : Point(0.0, 0.0), distanceToGoal(pose.position)};
  }

  // Whether the direction is that of the goal, everywhere.
  virtual bool isStraightLine() const { return false; }
};

}  // namespace pomdp_crowd_nav
