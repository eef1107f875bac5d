// SPDX-License-Identifier: BSD-3-Clause
#include "search_rig.h"

#include <cmath>
#include <random>

namespace pomdp_crowd_nav {
namespace {

const Bounds kField{{0.0, 0.0}, {100.0, 100.0}};
const Point kStart(1.0, 25.0);
const Point kGoal(100.0, 75.0);
const std::vector<Point> kCorners{{0.0, 0.0}, {0.0, 100.0}, {100.0, 100.0}, {100.0, 0.0}};
constexpr double kNearest = 3.0;    // [m]
constexpr double kFarthest = 15.0;  // [m]

PlannerParams plannerParams(const SearchRigParams& params) {
  PlannerParams planner;
  planner.pedestrians = params.pedestrians;
  planner.model.horizon = params.depth * planner.model.step;
  planner.model.bold_rollouts = params.bold_rollouts;
  planner.model.bold_distance = 2.5;
  planner.model.upper_bound = params.upper_bound;
  planner.search.scenarios = params.scenarios;
  planner.search.threads = params.threads;
  planner.search.max_depth = planner.model.depth();
  planner.search.discount = planner.model.discount();
  return planner;
}

// Uniform over the part of the ring about the start that is on the field.
Point placePerson(std::mt19937_64& random) {
  std::uniform_real_distribution<double> offset(-kFarthest, kFarthest);
  while (true) {
    const double dx = offset(random);
    const double dy = offset(random);
    const Point place = kStart + Point(dx, dy);
    const double distance = std::hypot(dx, dy);
    if (distance < kNearest || distance > kFarthest) continue;
    if (kField.contains(place)) return place;
  }
}

}  // namespace

SearchRig::SearchRig(const SearchRigParams& params)
    : params_(plannerParams(params)),
      map_(kField, {}),
      prior_(makeFieldPrior()),
      field_(*prior_, map_, params_.prior.resolution),
      model_(params_.model, field_, futures_),
      search_(params_.search) {}

SearchRig::Decision SearchRig::decide(std::uint64_t crowd, const SearchLimit& limit) {
  const auto start = SearchLimit::Clock::now();
  drawFutures(crowd);
  const auto result = search_.run(model_, {RobotState::from({kStart, 0.0, 0.0})}, limit);
  const std::chrono::duration<double> elapsed = SearchLimit::Clock::now() - start;
  return {result.statistics, elapsed.count()};
}

void SearchRig::drawFutures(std::uint64_t crowd) {
  std::mt19937_64 random(crowd);
  std::vector<PersonBelief> people;
  for (int i = 0; i < params_.pedestrians; ++i) {
    people.push_back({i, placePerson(random), {0.0, 0.0}, 1.0, IntentionBelief(kCorners.size())});
  }
  const StraightLinePedestrian walker({params_.model.pedestrian_noise * params_.model.step});
  futures_.draw(
      {params_.search.scenarios, params_.model.depth(), params_.model.step, map_.bounds()}, people,
      kCorners, walker, NoiseStreams(crowd));
}

CrowdModel SearchRig::model(const LaneKernel& kernel) const {
  return CrowdModel(params_.model, field_, futures_, kernel);
}

std::shared_ptr<const RolloutPrior> SearchRig::makeFieldPrior() const {
  PriorParams prior = params_.prior;
  prior.clearance = params_.model.obstacleClearance();
  return makePrior("fast_marching", map_, kGoal, prior);
}

}  // namespace pomdp_crowd_nav
