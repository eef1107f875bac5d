// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "pomdp_crowd_nav/pomdp/crowd_model.h"
#include "pomdp_crowd_nav/prior/prior_factory.h"

namespace pomdp_crowd_nav {

// A robot of the paper: any velocity at once, 1 s steps.
inline ModelParams paperModel() {
  ModelParams params;
  params.horizon = 25.0;
  params.bold_distance = 2.5;
  return params;
}

// A slow base whose velocity is a ramp over 0.5 s steps.
inline ModelParams rampedModel() {
  ModelParams params;
  params.vehicle.instant_velocity = false;
  params.vehicle.radius = 0.5;
  params.vehicle.max_speed = 1.5;
  params.vehicle.lateral_acceleration = 1.2;
  params.vehicle.brake_deceleration = 1.8;
  params.step = 0.5;
  params.horizon = 12.0;
  params.pedestrian_distance = 0.7;
  params.obstacle_distance = 0.4;
  params.near_distance = 2.5;
  params.far_distance = 4.0;
  params.bold_distance = 1.6;
  params.goal_tolerance = 0.5;
  return params;
}

// The paper's car.
inline ModelParams carModel() {
  ModelParams params = paperModel();
  params.vehicle.kind = VehicleKind::kCar;
  params.vehicle.max_speed = 4.0;
  params.vehicle.max_yaw_rate = 3.2;
  params.collision_checks = 5;
  return params;
}

// A small one that speeds up and brakes on its arcs, none of which is too fast.
inline ModelParams rampedCarModel() {
  ModelParams params = rampedModel();
  params.vehicle.kind = VehicleKind::kCar;
  params.vehicle.wheelbase = 0.6;
  params.vehicle.max_steering_angle = 0.5;
  params.vehicle.max_turn_per_step = 0.6;
  params.vehicle.max_yaw_rate = 0.9;
  params.collision_checks = 3;
  return params;
}

struct CrowdSceneParams {
  int people = 6;
  int scenarios = 8;
  bool obstacles = false;
  std::uint64_t seed = 1;
  bool walls = false;  // long ways round
  std::string prior = "fast_marching";
};

// A field of 40 m by 30 m with a goal near its right border and people all over it. Not copyable:
// a model refers to its parts.
class CrowdScene {
 public:
  using Params = CrowdSceneParams;

  CrowdScene(const ModelParams& model, const Params& params)
      : params_(params),
        model_(model),
        map_({{0.0, 0.0}, {40.0, 30.0}}, obstacles(params)),
        field_(*prior(), map_, 0.25),
        shortest_way_(makeShortestWay(model, ClearanceGrid(map_, 0.25), field_.goal())) {
    std::mt19937_64 random(params.seed);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    std::vector<PersonBelief> people;
    for (int i = 0; i < params.people; ++i) {
      const Point place(40.0 * unit(random), 30.0 * unit(random));
      people.push_back({i + 1, place, {0.0, 0.0}, 0.6 + 0.8 * unit(random), IntentionBelief(4)});
    }
    draw(people);
  }
  CrowdScene(const CrowdScene&) = delete;
  CrowdScene& operator=(const CrowdScene&) = delete;

  void draw(const std::vector<PersonBelief>& people) {
    const StraightLinePedestrian pedestrian({model_.pedestrian_noise * model_.step});
    futures_.draw({params_.scenarios, model_.depth(), model_.step, map_.bounds()}, people,
                  {{0.0, 0.0}, {0.0, 30.0}, {40.0, 30.0}, {40.0, 0.0}}, pedestrian,
                  NoiseStreams(params_.seed));
  }

  const StaticMap& map() const { return map_; }
  const NavigationField& field() const { return field_; }
  const ShortestWay* shortestWay() const { return shortest_way_ ? &*shortest_way_ : nullptr; }
  MapTables tables() const { return {field_, shortestWay()}; }
  const CrowdFutures& futures() const { return futures_; }
  const ModelParams& model() const { return model_; }

  // Anywhere, at any speed and also at rest and at full speed.
  RobotState randomState(std::mt19937_64& random) const {
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    const double max_speed = model_.vehicle.max_speed;
    const double choice = unit(random);
    const double speed = choice < 0.2 ? 0.0 : (choice < 0.4 ? max_speed : max_speed * unit(random));
    return RobotState::from(
        {Point(40.0 * unit(random), 30.0 * unit(random)), 2.0 * M_PI * unit(random), speed});
  }

 private:
  static StaticMap::Obstacles obstacles(const Params& params) {
    StaticMap::Obstacles some;
    if (params.obstacles) {
      some.circles = {{{12.0, 15.0}, 2.0}, {{26.0, 10.0}, 3.0}, {{26.0, 23.0}, 2.0}};
    }
    if (params.walls) {
      some.polygons = {{{{10.0, 0.0}, {13.0, 21.0}}, false},
                       {{{23.0, 30.0}, {21.0, 12.0}, {24.0, 9.0}}, false},
                       {{{31.0, 15.0}, {34.0, 15.0}, {34.0, 24.0}, {31.0, 24.0}}, true}};
    }
    return some;
  }

  std::shared_ptr<const RolloutPrior> prior() const {
    PriorParams prior;
    prior.resolution = 0.25;
    prior.clearance = model_.obstacleClearance();
    return makePrior(params_.prior, map_, {38.03, 19.07}, prior);
  }

  Params params_;
  ModelParams model_;
  StaticMap map_;
  NavigationField field_;
  std::optional<ShortestWay> shortest_way_;
  CrowdFutures futures_;
};

}  // namespace pomdp_crowd_nav
