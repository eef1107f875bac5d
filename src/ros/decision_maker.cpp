// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/ros/decision_maker.h"

#include <cmath>

namespace pomdp_crowd_nav {
namespace {

BlockingPerson::Params blockingParams(const NavigationParams& params) {
  const ModelParams& model = params.planning.model;
  return {params.emergency.decision_distance, model.pedestrianClearance(), model.near_distance};
}

std::optional<double> directionOf(const NavigationCell& guidance) {
  if (guidance.direction_x == 0.0F && guidance.direction_y == 0.0F) return std::nullopt;
  return std::atan2(guidance.direction_y, guidance.direction_x);
}

}  // namespace

DecisionMaker::DecisionMaker(const NavigationParams& params)
    : emergency_(params.emergency, params.planning.model.vehicle, params.planning.model.step),
      blocking_person_(blockingParams(params)) {}

Verdict DecisionMaker::decide(const Snapshot& snapshot, const SearchLimit& limit,
                              Planner& planner) const {
  const VehicleState& vehicle = snapshot.situation.vehicle;
  const NavigationCell guidance = planner.guidanceAt(snapshot.robot.position);
  Verdict verdict;
  Decision& decision = verdict.decision;
  decision = planner.decide(snapshot.situation, limit);
  if (const auto action = emergency_.replace(vehicle, snapshot.tracks)) {
    emergency_.apply(*action, vehicle, decision);
  }
  verdict.way = guidance.distance_to_goal;
  verdict.stands = vehicle.speed <= 0.0 && decision.motion.end_velocity.norm() <= 0.0;
  verdict.in_the_way =
      blocking_person_.find(vehicle.position, directionOf(guidance), snapshot.tracks);
  return verdict;
}

}  // namespace pomdp_crowd_nav
