// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>

#include "pomdp_crowd_nav/despot/search.h"
#include "pomdp_crowd_nav/path/hybrid_astar.h"
#include "pomdp_crowd_nav/planner/planner.h"
#include "pomdp_crowd_nav/planner/planner_factory.h"
#include "pomdp_crowd_nav/pomdp/path_model.h"
#include "pomdp_crowd_nav/prior/navigation_field.h"

namespace pomdp_crowd_nav {

// Searches speed alone, along a path that Hybrid A* finds anew for every decision (LS planner,
// 1D-A* in the paper). The older path is kept where no new one is found in time; with no path at
// all the robot rests.
//
// A holonomic base that takes any velocity at once and a car drive along the path itself. A
// holonomic base with ramps pursues it, and slows down where it cannot turn as the path does. A
// path bends no more than the car can at full speed.
class LimitedSpacePlanner : public Planner {
 public:
  LimitedSpacePlanner(const Task& task, const PlannerParams& params);

  // Throws std::invalid_argument for a car that can hardly turn at full speed.
  static void requireDrivable(const VehicleParams& vehicle);

  Decision decide(const Situation& situation, const SearchLimit& limit) override;
  TreeView viewTree(const TreeLimits& limits) const override;
  std::vector<Point> globalPath(const Point& from) const override;
  NavigationCell guidanceAt(const Point& place) const override {
    return field_.at(static_cast<float>(place.x()), static_cast<float>(place.y()));
  }
  Guidance guidance() const override { return {way_to_goal_, nullptr}; }

 private:
  void renewPath(const VehicleState& vehicle, const std::vector<PersonBelief>& people,
                 const SearchLimit& limit, Decision& decision);
  void dropDrivenPath(const VehicleState& vehicle);
  HybridAstar::Limit pathLimit(const SearchLimit& limit) const;
  void searchSpeed(const VehicleState& vehicle, const std::vector<PersonBelief>& people,
                   const SearchLimit& limit, Decision& decision);
  void rest(const VehicleState& vehicle, const SearchLimit& limit, Decision& decision) const;
  StepMotion motionAlong(const VehicleState& vehicle, float speed) const;
  StepMotion pursuit(const VehicleState& vehicle, float speed) const;
  std::vector<Point> pathToGoal() const;  // the present path and on to the goal
  std::vector<VehicleState> planFrom(const VehicleState& vehicle, const StepMotion& motion,
                                     const std::vector<Action>& actions) const;

  PlannerParams params_;
  ModelParams model_params_;
  StaticMap map_;
  Point goal_;
  std::vector<Point> destinations_;
  std::shared_ptr<const NavigationField> way_to_goal_;
  const NavigationField& field_;
  HybridAstar astar_;
  StraightLinePedestrian pedestrian_model_;
  CrowdFutures futures_;
  PathModel model_;
  Search<PathModel> search_;
  std::optional<Path> path_;  // from where the robot was at the last decision
  double planned_way_ = 0.0;  // [m], of the path, in the step that was decided last
  bool has_tree_ = false;
  std::uint64_t decisions_ = 0;
};

}  // namespace pomdp_crowd_nav
