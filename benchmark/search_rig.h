// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "pomdp_crowd_nav/despot/search.h"
#include "pomdp_crowd_nav/planner/planner.h"
#include "pomdp_crowd_nav/pomdp/crowd_model.h"

namespace pomdp_crowd_nav {

// What the benchmarks of the search vary; the rest is the paper's.
struct SearchRigParams {
  int pedestrians = 6;  // about the robot, and all of them attended
  int scenarios = 100;  // K
  int depth = 100;      // D, steps of 1 s
  int threads = 1;
  UpperBoundKind upper_bound = UpperBoundKind::kTight;
  bool bold_rollouts = true;
};

// The decision that they time: an empty field of 100 m by 100 m, a robot at rest at (1, 25) that
// faces east, its goal at (100, 75), and people 3 m to 15 m away of whom nothing is known but that
// each walks to one of the four corners. Roll-outs along the Fast Marching path.
class SearchRig {
 public:
  // Throws std::invalid_argument when a parameter is out of range.
  explicit SearchRig(const SearchRigParams& params);

  struct Decision {
    SearchStatistics search;
    double wall_time = 0.0;  // [s], with the drawing of the futures
  };
  // The same crowd gives the same people and the same futures.
  Decision decide(std::uint64_t crowd, const SearchLimit& limit);

  void drawFutures(std::uint64_t crowd);
  CrowdModel model(const LaneKernel& kernel) const;

  const PlannerParams& params() const { return params_; }
  const StaticMap& map() const { return map_; }
  const RolloutPrior& prior() const { return *prior_; }
  std::shared_ptr<const RolloutPrior> makeFieldPrior() const;

 private:
  PlannerParams params_;
  StaticMap map_;
  std::shared_ptr<const RolloutPrior> prior_;
  NavigationField field_;
  CrowdFutures futures_;
  CrowdModel model_;
  Search<CrowdModel> search_;
};

}  // namespace pomdp_crowd_nav
