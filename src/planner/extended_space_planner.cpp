// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/planner/extended_space_planner.h"

#include "pomdp_crowd_nav/planner/nearby_pedestrians.h"
#include "pomdp_crowd_nav/planner/tree_view.h"

namespace pomdp_crowd_nav {
namespace {

SearchParams searchParams(const PlannerParams& params) {
  SearchParams search = params.search;
  search.max_depth = params.model.depth();
  search.discount = params.model.discount();
  return search;
}

constexpr double kPathStep = 0.25;  // [m] between points of a path along the prior
constexpr size_t kMaxPathPoints = 8000;

}  // namespace

ExtendedSpacePlanner::ExtendedSpacePlanner(const Task& task,
                                           std::shared_ptr<const NavigationTables> tables,
                                           const PlannerParams& params)
    : params_(params),
      bounds_(task.map.bounds()),
      destinations_(task.destinations),
      tables_(std::move(tables)),
      field_(tables_->field),
      pedestrian_model_({params.model.pedestrian_noise * params.model.step}),
      model_(params.model, {field_, tables_->shortest_way ? &*tables_->shortest_way : nullptr},
             futures_),
      search_(searchParams(params)) {}

Decision ExtendedSpacePlanner::decide(const Situation& situation, const SearchLimit& limit) {
  const auto start = SearchLimit::Clock::now();
  const std::vector<PersonBelief> people =
      nearbyPedestrians(situation.crowd, situation.vehicle,
                        {params_.pedestrians, params_.attention_angle,
                         params_.model.pedestrian_distance, params_.attention_lookahead});
  const NoiseStreams noise(params_.seed + 0x9E3779B9ULL * decisions_++);
  futures_.draw({params_.search.scenarios, params_.model.depth(), params_.model.step, bounds_},
                people, destinations_, pedestrian_model_, noise);

  RobotState root = RobotState::from(situation.vehicle);
  // Odometry may report more than the limit, for which R_speed would be a reward.
  root.speed = std::min(root.speed, model_.constants().max_speed);
  const SearchResult<Action> result = search_.run(model_, {root}, limit);

  Decision decision;
  decision.action = result.action;
  decision.motion = motionOf(result.action, situation.vehicle);
  decision.plan = planFrom(root, result.plan);
  for (const PersonBelief& person : people) decision.attended.push_back(person.id);
  decision.search = result.statistics;
  decision.wall_time = std::chrono::duration<double>(SearchLimit::Clock::now() - start).count();
  return decision;
}

StepMotion ExtendedSpacePlanner::motionOf(const Action& action, const VehicleState& vehicle) const {
  const ModelParams& model = params_.model;
  const RobotState state = RobotState::from(vehicle);
  const double speed = model_.speedAfter(state, action);
  double heading = vehicle.heading + action.turn;
  const bool follows = action.heading == Action::Heading::kFollowPrior;
  if (follows) {
    const NavigationCell here = field_.at(state.x, state.y);
    heading = std::atan2(here.direction_y, here.direction_x);
  }
  if (model.vehicle.kind == VehicleKind::kCar) {
    if (follows && field_.isStraightLine()) heading = bearing(vehicle.position, field_.goal());
    const StepMotion arc = stepMotion(model.vehicle, vehicle, heading, speed, model.step);
    return follows ? stopAt(model.vehicle, field_.goal(), vehicle, arc).value_or(arc) : arc;
  }
  StepMotion motion = stepMotion(model.vehicle, vehicle, heading, speed, model.step);
  // A step along the prior ends on the goal rather than past it.
  const Point to_goal = field_.goal() - vehicle.position;
  if (follows && motion.instant && speed * model.step >= to_goal.norm()) {
    motion.end_velocity = to_goal / model.step;
  }
  return motion;
}

std::vector<VehicleState> ExtendedSpacePlanner::planFrom(const RobotState& state,
                                                         const std::vector<Action>& actions) const {
  std::vector<VehicleState> plan{state.vehicle()};
  RobotState now = state;
  for (const Action& action : actions) {
    now = model_.move(now, action);
    plan.push_back(now.vehicle());
  }
  return plan;
}

TreeView ExtendedSpacePlanner::viewTree(const TreeLimits& limits) const {
  TreeView view = viewOf(search_.tree(), search_.params(), limits,
                         [](const RobotState& state) { return state.vehicle().position; });
  for (const TreeEdge& edge : view.edges) {
    if (edge.depth == 1) view.rollouts.push_back(globalPath(edge.to));
  }
  return view;
}

std::vector<Point> ExtendedSpacePlanner::globalPath(const Point& from) const {
  std::vector<Point> path{from};
  while (path.size() < kMaxPathPoints) {
    const Point& here = path.back();
    if ((field_.goal() - here).norm() <= kPathStep) {
      path.push_back(field_.goal());
      break;
    }
    const NavigationCell cell =
        field_.at(static_cast<float>(here.x()), static_cast<float>(here.y()));
    const Point direction(cell.direction_x, cell.direction_y);
    if (direction.isZero()) break;
    Point next = here + kPathStep * direction;
    // Directions are those of the cells' centres and may lead a little beyond the border.
    if (bounds_.contains(here)) next = next.cwiseMax(bounds_.min).cwiseMin(bounds_.max);
    path.push_back(next);
  }
  return path;
}

}  // namespace pomdp_crowd_nav
