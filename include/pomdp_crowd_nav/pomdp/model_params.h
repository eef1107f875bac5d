// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pomdp_crowd_nav/world/vehicle.h"

namespace pomdp_crowd_nav {

// Most tests of a step, see ModelParams::collision_checks.
constexpr int kMaxCollisionChecks = 10;

// The paper's reward model (section Reward Modeling); costs are negative.
struct RewardParams {
  double goal = 1000.0;         // R_goal, once, in the step after arrival
  double pedestrian = -100.0;   // R_ped, moving too close to a person ends the scenario
  double obstacle = -100.0;     // R_obs, too close to an obstacle or off the field ends it too
  double sudden_brake = -10.0;  // R_SB, per sudden brake
  double time = -1.0;           // R_t [1/s]
  double low_speed = -1.0;      // R_speed [1/s] at rest, falling linearly to 0 at full speed
};

// What is counted as the return of a roll-out that has not reached the goal at the horizon.
enum class BeyondHorizon {
  kNothing,   // 0, as the paper
  kFreeDrive  // what a drive at full speed along the prior's path would bring, with nobody about
};

enum class UpperBoundKind {
  kPaper,  // gamma^t R_goal with t the time of the straight line at full speed
  kTight   // the same less the costs of time that no drive of that length avoids
};

// The POMDP; distances are from centre to centre or from the centre to an obstacle's surface.
struct ModelParams {
  VehicleParams vehicle;
  RewardParams reward;
  double step = 1.0;                  // [s], decision period, Delta t
  double horizon = 100.0;             // [s], roll-outs and trials end here, M and D times step
  double discount_per_second = 0.97;  // gamma of a 1 s step
  double goal_tolerance = 1.0;        // [m], D_g
  double pedestrian_distance = 1.0;   // [m], D_ped; the robot's radius comes on top
  double obstacle_distance = 2.0;     // [m], D_obs; the robot's radius comes on top
  // Moments of a step, evenly spread and the last at its end, at which the distances to people and
  // obstacles are tested; 2 as for the paper's holonomic robot, 5 as for its car.
  int collision_checks = 2;
  double near_distance = 4.0;  // [m], D_near: roll-outs slow down closer than this
  double far_distance = 6.0;   // [m], D_far: roll-outs speed up beyond this
  // [m], both distances of a second, bolder roll-out policy; 0: never slows down
  double bold_distance = 0.0;
  bool bold_rollouts = true;      // value leaves by the better of the two policies
  double pedestrian_noise = 0.1;  // [m], half width of the noise on a step of 1 s
  BeyondHorizon beyond_horizon = BeyondHorizon::kNothing;
  UpperBoundKind upper_bound = UpperBoundKind::kTight;

  int depth() const;        // D, steps to the horizon
  double discount() const;  // gamma of one step
  double speedStep() const { return vehicle.acceleration * step; }
  double pedestrianClearance() const { return pedestrian_distance + vehicle.radius; }
  double obstacleClearance() const { return obstacle_distance + vehicle.radius; }
};

// Throws std::invalid_argument naming the first field that is out of range.
void validate(const ModelParams& params);

}  // namespace pomdp_crowd_nav
