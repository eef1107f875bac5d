// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "pomdp_crowd_nav/despot/search.h"
#include "pomdp_crowd_nav/planner/navigation_tables.h"
#include "pomdp_crowd_nav/planner/planner.h"
#include "pomdp_crowd_nav/planner/planner_factory.h"
#include "pomdp_crowd_nav/pomdp/crowd_model.h"

namespace pomdp_crowd_nav {

// Searches speed and heading together (ES planner in the paper), with roll-outs along a prior:
// 2D-FMM and 2D-PRM are this class with different priors.
class ExtendedSpacePlanner : public Planner {
 public:
  ExtendedSpacePlanner(const Task& task, std::shared_ptr<const NavigationTables> tables,
                       const PlannerParams& params);

  Decision decide(const Situation& situation, const SearchLimit& limit) override;
  TreeView viewTree(const TreeLimits& limits) const override;
  std::vector<Point> globalPath(const Point& from) const override;
  NavigationCell guidanceAt(const Point& place) const override {
    return field_.at(static_cast<float>(place.x()), static_cast<float>(place.y()));
  }
  Guidance guidance() const override { return {{tables_, &field_}, tables_->prior}; }
  bool pathAvoidsObstacles() const override { return !field_.isStraightLine(); }

 private:
  StepMotion motionOf(const Action& action, const VehicleState& vehicle) const;
  std::vector<VehicleState> planFrom(const RobotState& state,
                                     const std::vector<Action>& actions) const;

  PlannerParams params_;
  Bounds bounds_;
  std::vector<Point> destinations_;
  std::shared_ptr<const NavigationTables> tables_;
  const NavigationField& field_;
  StraightLinePedestrian pedestrian_model_;
  CrowdFutures futures_;
  CrowdModel model_;
  Search<CrowdModel> search_;
  std::uint64_t decisions_ = 0;
};

}  // namespace pomdp_crowd_nav
