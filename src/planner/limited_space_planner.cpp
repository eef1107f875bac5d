// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/planner/limited_space_planner.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "pomdp_crowd_nav/planner/nearby_pedestrians.h"
#include "pomdp_crowd_nav/planner/tree_view.h"

namespace pomdp_crowd_nav {
namespace {

constexpr double kPathStep = 0.25;      // [m], between points of a path that is shown
constexpr double kOnPath = 1e-6;        // [m], of where the last step should have ended
constexpr double kFarOffPath = 0.5;     // [m], a path so far away is dropped
constexpr double kOffHeading = 0.2;     // [rad], of a car, which cannot get onto such a path
constexpr double kPursuedAhead = 0.5;   // [m], beyond the end of the step
constexpr double kReachableTurn = 0.1;  // [rad], a turn that falls short by more is too sharp

SearchParams searchParams(const PlannerParams& params) {
  SearchParams search = params.search;
  search.max_depth = params.model.depth();
  search.discount = params.model.discount();
  return search;
}

ModelParams modelParams(const PlannerParams& params) {
  ModelParams model = params.model;
  model.pedestrian_noise = params.limited_space.pedestrian_noise;
  return model;
}

HybridAstar::Params pathParams(const PlannerParams& params) {
  HybridAstar::Params path = params.limited_space.path;
  path.vehicle = params.model.vehicle.kind;
  path.max_turn = HybridAstar::maxTurn(params.model.vehicle);
  path.clearance = params.model.obstacleClearance();
  path.goal_tolerance = params.model.goal_tolerance;
  path.crowd.clearance = params.model.pedestrianClearance();
  const double pace = params.limited_space.pace;
  path.crowd.pace = pace > 0.0 ? pace : params.model.vehicle.max_speed;
  return path;
}

// The way to the goal that guides the path search: round the obstacles, where there are any.
NavigationField wayToGoal(const Task& task, const PlannerParams& params) {
  PriorParams prior = params.prior;
  prior.clearance = params.model.obstacleClearance();
  prior.robot_radius = params.model.vehicle.radius;
  prior.extra_clearance = 0.0;
  const char* kind = task.map.hasObstacles() ? "fast_marching" : "straight_line";
  const auto clearances = clearancesOf(task, prior);
  return NavigationField(*makePrior(kind, *clearances, task.goal, prior), *clearances);
}

void addPoints(const Path& path, std::vector<Point>& points) {
  const int count = static_cast<int>(std::ceil(path.length() / kPathStep - 1e-9));
  for (int i = 1; i <= count; ++i) points.push_back(path.positionAt(i * kPathStep));
}

void addLine(const Point& to, std::vector<Point>& points) {
  const Point from = points.back();
  const int count = std::max(1, static_cast<int>(std::ceil((to - from).norm() / kPathStep)));
  for (int i = 1; i < count; ++i) points.push_back(from + (to - from) * i / count);
  points.push_back(to);
}

}  // namespace

void LimitedSpacePlanner::requireDrivable(const VehicleParams& vehicle) {
  const double turn = HybridAstar::maxTurn(vehicle);
  if (vehicle.kind == VehicleKind::kHolonomic || turn >= HybridAstar::kTurnStep) return;
  throw std::invalid_argument(fmt::format(
      "max_steering_angle, wheelbase, max_vel_theta{} must allow a car of planner '1d_astar' to "
      "turn by {:.3f} rad on 1 m at max_vel_trans, got {:.3f}",
      vehicle.instant_velocity ? "" : ", acc_lim_y", HybridAstar::kTurnStep, turn));
}

LimitedSpacePlanner::LimitedSpacePlanner(const Task& task, const PlannerParams& params)
    : params_(params),
      model_params_(modelParams(params)),
      map_(task.map),
      goal_(task.goal),
      destinations_(task.destinations),
      way_to_goal_(std::make_shared<const NavigationField>(wayToGoal(task, params))),
      field_(*way_to_goal_),
      astar_(task.map, field_, pathParams(params)),
      pedestrian_model_({model_params_.pedestrian_noise * model_params_.step}),
      model_(model_params_, futures_),
      search_(searchParams(params)) {
  requireDrivable(params.model.vehicle);
}

Decision LimitedSpacePlanner::decide(const Situation& situation, const SearchLimit& limit) {
  const auto start = SearchLimit::Clock::now();
  const std::vector<PersonBelief> people =
      nearbyPedestrians(situation.crowd, situation.vehicle,
                        {params_.pedestrians, params_.attention_angle,
                         params_.model.pedestrian_distance, params_.attention_lookahead});
  Decision decision;
  for (const PersonBelief& person : people) decision.attended.push_back(person.id);
  renewPath(situation.vehicle, people, limit, decision);
  if (path_) {
    searchSpeed(situation.vehicle, people, limit, decision);
  } else {
    rest(situation.vehicle, limit, decision);
  }
  has_tree_ = path_.has_value();
  decision.path = has_tree_ ? pathToGoal() : std::vector<Point>{situation.vehicle.position};
  ++decisions_;
  decision.wall_time = std::chrono::duration<double>(SearchLimit::Clock::now() - start).count();
  return decision;
}

void LimitedSpacePlanner::renewPath(const VehicleState& vehicle,
                                    const std::vector<PersonBelief>& people,
                                    const SearchLimit& limit, Decision& decision) {
  dropDrivenPath(vehicle);
  const Pose start{vehicle.position, vehicle.heading};
  HybridAstar::Result found = astar_.find(start, people, destinations_, pathLimit(limit));
  decision.path_expansions = found.expansions;
  decision.has_fresh_path = found.outcome == HybridAstar::Outcome::kFound;
  if (!decision.has_fresh_path && !path_) {
    found = astar_.find(start, {}, destinations_, pathLimit(limit));
    decision.path_expansions += found.expansions;
  }
  if (found.outcome == HybridAstar::Outcome::kFound) path_ = std::move(found.path);
}

void LimitedSpacePlanner::dropDrivenPath(const VehicleState& vehicle) {
  if (!path_) return;
  double driven = planned_way_;
  if ((path_->positionAt(driven) - vehicle.position).norm() > kOnPath) {
    const ModelParams& model = params_.model;
    driven = path_->nearestTo(vehicle.position, model.vehicle.max_speed * model.step + kFarOffPath);
  }
  const double turned = wrapAngle(path_->headingAt(driven) - vehicle.heading);
  const bool looks_away =
      params_.model.vehicle.kind == VehicleKind::kCar && std::abs(turned) > kOffHeading;
  if (looks_away || (path_->positionAt(driven) - vehicle.position).norm() > kFarOffPath) {
    path_.reset();
  } else {
    path_ = path_->from(driven);
  }
}

HybridAstar::Limit LimitedSpacePlanner::pathLimit(const SearchLimit& limit) const {
  HybridAstar::Limit path;
  if (limit.deadline == SearchLimit::Clock::time_point::max()) {
    path.max_expansions = params_.limited_space.max_expansions;
  } else {
    const auto now = SearchLimit::Clock::now();
    path.deadline = now + std::chrono::duration_cast<SearchLimit::Clock::duration>(
                              params_.limited_space.time_share * (limit.deadline - now));
  }
  return path;
}

void LimitedSpacePlanner::searchSpeed(const VehicleState& vehicle,
                                      const std::vector<PersonBelief>& people,
                                      const SearchLimit& limit, Decision& decision) {
  const NoiseStreams noise(params_.seed + 0x9E3779B9ULL * decisions_);
  futures_.draw(
      {params_.search.scenarios, model_params_.depth(), model_params_.step, map_.bounds()}, people,
      destinations_, pedestrian_model_, noise);
  model_.setPath(*path_);
  // Odometry may report more than the limit, for which R_speed would be a reward.
  const PathState root{
      0.0F, static_cast<float>(std::min(vehicle.speed, model_params_.vehicle.max_speed))};
  const SearchResult<Action> result = search_.run(model_, {root}, limit);
  const float speed = model_.speedAfter(root, result.action);
  planned_way_ = model_.move(root, speed).way;
  decision.action = result.action;
  decision.motion = motionAlong(vehicle, speed);
  decision.plan = planFrom(vehicle, decision.motion, result.plan);
  decision.search = result.statistics;
}

void LimitedSpacePlanner::rest(const VehicleState& vehicle, const SearchLimit& limit,
                               Decision& decision) const {
  const VehicleParams& base = model_params_.vehicle;
  const double speed = speedAfterBrake(base, vehicle.speed, model_params_.step);
  decision.action = Action::turnBy(0.0, vehicle.speed > 0.0 ? -1 : 0);
  decision.motion = stepMotion(base, vehicle, vehicle.heading, speed, model_params_.step);
  decision.plan = {vehicle, decision.motion.end()};
  const bool is_late = SearchLimit::Clock::now() >= limit.deadline;
  decision.search.stop = is_late ? SearchStop::kDeadline : SearchStop::kTrialLimit;
}

StepMotion LimitedSpacePlanner::motionAlong(const VehicleState& vehicle, float speed) const {
  const VehicleParams& base = model_params_.vehicle;
  if (base.kind == VehicleKind::kHolonomic && !base.instant_velocity) {
    return pursuit(vehicle, speed);
  }
  StepMotion motion =
      stepMotion(base, vehicle, vehicle.heading, static_cast<double>(speed), model_params_.step);
  motion.legs = path_->firstLegs(planned_way_);
  if (motion.legs.empty() && !base.instant_velocity) {
    const double slowed = speedAfterBrake(base, vehicle.speed, model_params_.step);
    return stepMotion(base, vehicle, vehicle.heading, slowed, model_params_.step);
  }
  if (motion.legs.empty()) {
    motion.end_velocity = Point(0.0, 0.0);
    return motion;
  }
  const PathLeg& last = motion.legs.back();
  motion.end_heading = last.headingAt(last.length);
  motion.end_velocity = static_cast<double>(speed) * unitVector(motion.end_heading);
  return motion;
}

StepMotion LimitedSpacePlanner::pursuit(const VehicleState& vehicle, float speed) const {
  const VehicleParams& base = model_params_.vehicle;
  const double ahead = planned_way_ + kPursuedAhead;
  const Point target = ahead < path_->length() ? path_->positionAt(ahead) : goal_;
  const double desired = bearing(vehicle.position, target);
  const double reached =
      turnToward(vehicle.heading, desired, maxTurnChord(base, vehicle.speed, model_params_.step));
  double kept = speed;
  if (std::abs(wrapAngle(desired - reached)) > kReachableTurn) {
    kept = std::min(kept, speedAfter(base, vehicle.speed, -base.acceleration * model_params_.step));
  }
  return stepMotion(base, vehicle, desired, kept, model_params_.step);
}

std::vector<VehicleState> LimitedSpacePlanner::planFrom(const VehicleState& vehicle,
                                                        const StepMotion& motion,
                                                        const std::vector<Action>& actions) const {
  std::vector<VehicleState> plan{vehicle, motion.end()};
  PathState state{static_cast<float>(planned_way_), static_cast<float>(plan.back().speed)};
  for (size_t i = 1; i < actions.size(); ++i) {
    state = model_.move(state, model_.speedAfter(state, actions[i]));
    plan.push_back({path_->positionAt(state.way), path_->headingAt(state.way), state.speed});
  }
  return plan;
}

TreeView LimitedSpacePlanner::viewTree(const TreeLimits& limits) const {
  if (!has_tree_) return {};
  TreeView view = viewOf(search_.tree(), search_.params(), limits,
                         [this](const PathState& state) { return model_.positionAt(state.way); });
  if (view.edges.empty()) return view;
  view.rollouts.push_back(pathToGoal());
  return view;
}

std::vector<Point> LimitedSpacePlanner::pathToGoal() const {
  std::vector<Point> way{path_->positionAt(0.0)};
  addPoints(*path_, way);
  addLine(goal_, way);
  return way;
}

// A search of its own, for this is also asked from other threads.
std::vector<Point> LimitedSpacePlanner::globalPath(const Point& from) const {
  HybridAstar astar(map_, field_, pathParams(params_));
  const NavigationCell here = field_.at(static_cast<float>(from.x()), static_cast<float>(from.y()));
  const Pose start{from, std::atan2(here.direction_y, here.direction_x)};
  HybridAstar::Limit limit;
  limit.max_expansions = params_.limited_space.max_expansions;
  const HybridAstar::Result found = astar.find(start, {}, destinations_, limit);
  std::vector<Point> points{from};
  if (found.outcome != HybridAstar::Outcome::kFound) return points;
  addPoints(found.path, points);
  addLine(goal_, points);
  // A car's arc along the border may bulge a little beyond it.
  const Bounds& bounds = map_.bounds();
  if (!bounds.contains(from)) return points;
  for (Point& point : points) point = point.cwiseMax(bounds.min).cwiseMin(bounds.max);
  return points;
}

}  // namespace pomdp_crowd_nav
