// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "pomdp_crowd_nav/despot/expansion.h"
#include "pomdp_crowd_nav/path/path.h"
#include "pomdp_crowd_nav/pomdp/action.h"
#include "pomdp_crowd_nav/pomdp/crowd_futures.h"
#include "pomdp_crowd_nav/pomdp/upper_bound.h"

namespace pomdp_crowd_nav {

// A robot on a path.
struct PathState {
  float way = 0.0F;    // [m] driven along the path
  float speed = 0.0F;  // [m/s]
};

// The POMDP of speed along one path as a model for the DESPOT search (LS planner in the paper):
// rewards of CrowdModel without obstacles and borders, of which the path keeps clear. The end of
// the path is the goal; who passes it stops there.
//
// Distances to people are tested where a step starts if the robot moves then, and in the step once
// for every metre begun, evenly in time: at 1 m/s at its end, at 2 m/s half way too (facts sheet,
// section 3). Leaves are valued by the roll-out policies of CrowdModel, along the path.
//
// Refers to the futures, which must outlive it. Its expand is const and thread-safe.
class PathModel {
 public:
  using State = PathState;
  using Action = pomdp_crowd_nav::Action;
  static constexpr bool kSharesState = true;  // the robot's state; people are in the futures

  PathModel(const ModelParams& params, const CrowdFutures& futures);

  // For the searches that follow.
  void setPath(const Path& path);

  // {+1, 0, -1, SB}: the first of equals is taken. Left out is what does the same as another for no
  // less: +1 at full speed, -1 at rest, SB where -1 brakes as hard.
  void actions(const PathState& state, std::vector<Action>& out) const;

  Branch step(const PathState& state, int scenario, int depth, const Action& action,
              PathState& next) const;
  void bound(const PathState& state, int scenario, int depth, Branch& branch) const;

  void expand(const PathState* states, const int* scenarios, int count, int depth,
              Expansion<PathModel>& out) const {
    expandOneByOne(*this, states, scenarios, count, depth, out);
  }
  void rootBounds(const PathState* states, const int* scenarios, int count, double& lower,
                  double& upper) const {
    boundOneByOne(*this, states, scenarios, count, lower, upper);
  }
  Action defaultAction(const PathState* state) const;

  float speedAfter(const PathState& state, const Action& action) const;  // [m/s]
  PathState move(const PathState& state, float new_speed) const;
  Point positionAt(float way) const;

 private:
  struct Place {
    float x, y;
  };
  struct Encounter {
    bool collides;
    float end_sq;  // [m^2], to the nearest person at the end of the step
  };

  Place placeAt(float way) const;
  float nearestSq(const Place& robot, int scenario, int depth) const;
  Encounter meet(const PathState& state, float new_speed, int scenario, int depth,
                 float start_sq) const;
  float wayAfter(const PathState& state, float new_speed, float share) const;
  float upperFrom(const PathState& state) const;
  float rollOut(const PathState& from, int scenario, int depth, int policy) const;
  float stepCost(float speed) const;
  bool hasArrived(float way) const;

  ModelParams params_;
  const CrowdFutures& futures_;
  UpperBound upper_bound_;
  float step_, discount_, max_speed_, speed_step_, brake_step_;
  float pedestrian_clearance_sq_;
  float length_ = 0.0F;        // [m]
  std::vector<Place> places_;  // along the path, evenly spaced
};

}  // namespace pomdp_crowd_nav
