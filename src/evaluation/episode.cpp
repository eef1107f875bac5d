// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/evaluation/episode.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "pomdp_crowd_nav/evaluation/reachability.h"
#include "pomdp_crowd_nav/planner/planner_factory.h"

namespace pomdp_crowd_nav {
namespace {

// The closed loop of one trip; `run` drives it to its end.
class Trip {
 public:
  Trip(const World& world, const EpisodeParams& params)
      : params_(params),
        model_(params.navigation.planning.model),
        map_(world.map()),
        simulator_(world, simulatorParams(params)),
        tracker_(world.destinations, params.navigation.belief),
        override_(params.navigation.emergency, model_.vehicle, model_.step),
        commands_(params.navigation.command, model_.vehicle),
        recorder_({model_.step}),
        travel_heading_(world.start.heading) {
    PlannerParams planning = params.navigation.planning;
    planning.seed = params.seed;
    planner_ = makePlanner(params.navigation.planner,
                           {map_, world.goal, world.destinations, params.tables.get()}, planning);
  }

  EpisodeResult run(const std::function<void(const EpisodeMoment&)>& observer) {
    sense();
    drive(model_.step);
    while (!isOver()) {
      const Decision decision = decide();
      if (observer)
        observer({simulator_.time(), decision, simulator_, *planner_, tracker_.belief()});
      commands_.follow(decision.motion, simulator_.time());
      travel_heading_ = decision.motion.end_heading;
      motion_ = decision.motion;
      motion_start_ = simulator_.time();
      drive(model_.step);
    }
    result_.metrics = recorder_.metrics();
    if (result_.metrics.decisions > 0) {
      result_.mean_search_time /= result_.metrics.decisions;
      result_.mean_trials /= result_.metrics.decisions;
    }
    return result_;
  }

  // Why the goal cannot be reached even if nobody were about; empty when it can.
  std::string whyNot() const {
    const World& world = simulator_.world();
    const std::string reason = whyNotAPlace(world.goal, map_, model_);
    if (!reason.empty()) return reason;
    return whyNoWay(*planner_, {world.start.position, world.goal}, map_, model_);
  }

 private:
  static Simulator::Params simulatorParams(const EpisodeParams& params) {
    Simulator::Params simulator = params.simulator;
    simulator.seed = params.seed;
    return simulator;
  }

  // Tests at step boundaries only, the goal first, as the authors' loop does.
  bool isOver() {
    const Point& position = simulator_.base().pose().position;
    if ((position - simulator_.world().goal).norm() <= model_.goal_tolerance) {
      result_.end = EpisodeEnd::kGoalReached;
    } else if (!map_.bounds().contains(position)) {
      result_.end = EpisodeEnd::kLeftField;
    } else if (map_.clearance(position) <= 0.0) {
      result_.end = EpisodeEnd::kHitObstacle;
    } else if (simulator_.time() > params_.time_limit) {
      result_.end = EpisodeEnd::kTimeLimit;
    } else {
      return false;
    }
    return true;
  }

  VehicleState vehicle() const {
    const bool bends =
        motion_ && !motion_->legs.empty() && model_.vehicle.kind == VehicleKind::kHolonomic;
    if (bends && !commands_.isStopping(simulator_.time())) return onBentWay();
    const Point& velocity = simulator_.base().velocity();
    const double speed = velocity.norm();
    double heading = speed > 1e-3 ? std::atan2(velocity.y(), velocity.x()) : travel_heading_;
    if (model_.vehicle.kind == VehicleKind::kCar) heading = simulator_.base().pose().heading;
    return {simulator_.base().pose().position, heading, speed > 1e-3 ? speed : 0.0};
  }

  // On a bent way the velocity is a mean over a tick.
  VehicleState onBentWay() const {
    constexpr double kRounding = 1e-9;  // [s]
    const double time = simulator_.time() - motion_start_;
    const double within = time > motion_->duration - kRounding ? motion_->duration : time;
    return {simulator_.base().pose().position, motion_->headingAt(within),
            motion_->velocityAt(within).norm()};
  }

  Decision decide() {
    Situation situation{vehicle(), tracker_.belief()};
    TrackList tracks = tracks_;
    predictPeople(simulator_.time() - tracks.stamp, situation.crowd, tracks);
    SearchLimit limit;
    if (params_.max_trials > 0) {
      limit = SearchLimit::trials(params_.max_trials);
    } else {
      limit =
          SearchLimit::until(SearchLimit::Clock::now() +
                             std::chrono::duration_cast<SearchLimit::Clock::duration>(
                                 std::chrono::duration<double>(params_.navigation.search_time)));
    }
    Decision decision = planner_->decide(situation, limit);
    if (const auto action = override_.replace(situation.vehicle, tracks)) {
      override_.apply(*action, situation.vehicle, decision);
    }
    recorder_.countDecision(decision.action.sudden_brake && situation.vehicle.speed > 0.0, false);
    result_.mean_search_time += decision.wall_time;
    result_.max_search_time = std::max(result_.max_search_time, decision.wall_time);
    result_.mean_trials += static_cast<double>(decision.search.trials);
    result_.bound_violations += decision.search.bound_violations;
    if (!decision.has_fresh_path) ++result_.stale_paths;
    return decision;
  }

  // Moves the world on by `duration`, tick by tick, with commands and beliefs kept up.
  void drive(double duration) {
    const long ticks = std::lround(duration / Crowd::kTick);
    for (long i = 0; i < ticks; ++i) {
      const SimulatedBase& base = simulator_.base();
      simulator_.setCommand(
          commands_.commandAt(simulator_.time(), base.pose().heading, base.velocity()));
      const double speed_before = base.velocity().norm();
      simulator_.advance(Crowd::kTick);
      const Point& position = simulator_.base().pose().position;
      const double speed = std::max(speed_before, simulator_.base().velocity().norm());
      recorder_.tick(simulator_.time(), position, movingSpeed(speed), simulator_.crowd().walkers());
      result_.trail.push_back(position);
      sense();
      brakeForPeople();
    }
  }

  // The reflex between decisions.
  void brakeForPeople() {
    TrackList tracks = tracks_;
    CrowdBelief nobody;
    predictPeople(simulator_.time() - tracks.stamp, nobody, tracks);
    if (commands_.isStopping(simulator_.time())) return;
    if (!override_.reflex(vehicle(), tracks, simulator_.base().yawRate())) return;
    commands_.stop();
    recorder_.countReflex();
  }

  // An instant base that was stopped for this tick is at rest in it, whatever it did before.
  double movingSpeed(double speed) const {
    return model_.vehicle.instant_velocity ? simulator_.base().velocity().norm() : speed;
  }

  void sense() {
    tracker_.update(simulator_.sense());
    tracks_ = tracksOf(tracker_.belief());
  }

  EpisodeParams params_;
  ModelParams model_;
  StaticMap map_;
  Simulator simulator_;
  BeliefTracker tracker_;
  EmergencyOverride override_;
  CommandGenerator commands_;
  MetricsRecorder recorder_;
  std::unique_ptr<Planner> planner_;
  TrackList tracks_;
  double travel_heading_;
  std::optional<StepMotion> motion_;  // of the last decision
  double motion_start_ = 0.0;         // [s]
  EpisodeResult result_;
};

}  // namespace

const char* describe(EpisodeEnd end) {
  switch (end) {
    case EpisodeEnd::kGoalReached:
      return "goal reached";
    case EpisodeEnd::kTimeLimit:
      return "time limit";
    case EpisodeEnd::kLeftField:
      return "left the field";
    case EpisodeEnd::kHitObstacle:
      return "hit an obstacle";
  }
  return "unknown";
}

void requireDrivable(const World& world, const EpisodeParams& params) {
  std::string reason;
  try {
    reason = Trip(world, params).whyNot();
  } catch (const std::exception& error) {
    reason = error.what();
  }
  if (!reason.empty()) throw std::runtime_error(world.name + ": " + reason);
}

EpisodeResult runEpisode(const World& world, const EpisodeParams& params,
                         const std::function<void(const EpisodeMoment&)>& observer) {
  return Trip(world, params).run(observer);
}

}  // namespace pomdp_crowd_nav
