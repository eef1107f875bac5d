// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "pomdp_crowd_nav/pomdp/crowd_model.h"

namespace pomdp_crowd_nav {

// The POMDP's step and its roll-outs once more: in double, with angles, one robot at a time, as
// the paper and the facts sheet tell it and not as the kernels compute it. It shares with them
// only the tables (people's places, cells of the field).
//
// Also tells how near any of its yes-or-no questions came to the other answer, so that a
// comparison can leave out cases that rounding decides.
class ReferenceModel {
 public:
  struct Outcome {
    double reward = 0.0;
    bool terminal = false;
    VehicleState next;
    double rollouts[2] = {0.0, 0.0};
    long rollout_steps = 0;
    double margin = std::numeric_limits<double>::infinity();  // [m], [m/s] or [rad]
  };

  ReferenceModel(const ModelParams& params, const NavigationField& field,
                 const CrowdFutures& futures)
      : p_(params), field_(field), futures_(futures) {}

  Outcome step(const VehicleState& robot, int scenario, int depth, const Action& action) {
    margin_ = std::numeric_limits<double>::infinity();
    const bool follows = action.heading == Action::Heading::kFollowPrior;
    const double heading =
        follows ? priorHeading(robot.position) : robot.heading + static_cast<double>(action.turn);
    if (isCar()) noteTurn(robot, heading);
    const Result result =
        advance({robot, scenario, depth}, heading, speedAfter(robot.speed, action), follows);
    Outcome outcome;
    outcome.reward = result.reward + (action.sudden_brake ? p_.reward.sudden_brake : 0.0);
    outcome.terminal = result.terminal;
    outcome.next = result.next;
    for (int policy = 0; !outcome.terminal && policy < (p_.bold_rollouts ? 2 : 1); ++policy) {
      outcome.rollouts[policy] =
          rollOut({outcome.next, scenario, depth + 1}, policy, outcome.rollout_steps);
    }
    outcome.margin = margin_;
    return outcome;
  }

  double rollOut(const VehicleState& robot, int scenario, int policy) {
    long steps = 0;
    return rollOut({robot, scenario, 0}, policy, steps);
  }

 private:
  struct Moment {
    VehicleState robot;
    int scenario;
    int depth;
  };
  struct Result {
    double reward = 0.0;
    bool terminal = false;
    VehicleState next;
  };

  // a <= b, with a note of how close it was.
  bool atMost(double a, double b) {
    margin_ = std::min(margin_, std::abs(a - b));
    return a <= b;
  }

  bool isMoving(double speed) {
    if (speed == 0.0) return false;
    margin_ = std::min(margin_, speed);
    return true;
  }

  NavigationCell cell(const Point& point) {
    const double scale = field_.raster().cells_per_meter;
    for (const double place : {(point.x() - field_.bounds().min.x()) * scale,
                               (point.y() - field_.bounds().min.y()) * scale}) {
      margin_ = std::min(margin_, std::abs(place - std::round(place)) / scale);
    }
    return field_.at(static_cast<float>(point.x()), static_cast<float>(point.y()));
  }

  double priorHeading(const Point& point) {
    if (isCar() && field_.isStraightLine()) {
      const Point way = field_.goal() - point;
      return std::atan2(way.y(), way.x());
    }
    const NavigationCell here = cell(point);
    return std::atan2(here.direction_y, here.direction_x);
  }

  double speedAfter(double speed, const Action& action) const {
    const VehicleParams& v = p_.vehicle;
    if (action.sudden_brake) {
      return v.instant_velocity ? 0.0 : std::max(0.0, speed - v.brake_deceleration * p_.step);
    }
    return std::clamp(speed + action.speed_steps * v.acceleration * p_.step, 0.0, v.max_speed);
  }

  double nearest(const Point& robot, const Moment& moment, double share) {
    double nearest = std::numeric_limits<double>::infinity();
    const auto* from = futures_.at(moment.scenario, moment.depth);
    const auto* to = futures_.at(moment.scenario, moment.depth + (share > 0.0 ? 1 : 0));
    for (int i = 0; i < futures_.personCount(); ++i) {
      const Point a(from[i].x, from[i].y);
      const Point b(to[i].x, to[i].y);
      nearest = std::min(nearest, ((1.0 - share) * a + share * b - robot).norm());
    }
    return nearest;
  }

  // Speed times the chord between the directions is what lateral acceleration allows in a step.
  double reachableHeading(const VehicleState& robot, double desired) {
    if (p_.vehicle.instant_velocity || robot.speed == 0.0) return desired;
    const double chord = p_.vehicle.lateral_acceleration * p_.step / robot.speed;
    if (chord >= 2.0) return desired;
    const double largest = 2.0 * std::asin(0.5 * chord);
    const double turn = std::remainder(desired - robot.heading, 2.0 * M_PI);
    margin_ = std::min(margin_, M_PI - std::abs(turn));
    return robot.heading + std::clamp(turn, -largest, largest);
  }

  bool isCar() const { return p_.vehicle.kind == VehicleKind::kCar; }

  // A car that wants to turn back may turn either way.
  void noteTurn(const VehicleState& robot, double desired) {
    const double turn = std::remainder(desired - robot.heading, 2.0 * M_PI);
    margin_ = std::min(margin_, M_PI - std::abs(turn));
  }

  // The places of a car's step: on the arc of one steering angle.
  std::vector<Point> drive(const VehicleState& robot, double desired, double new_speed,
                           bool stops_at_goal, double& heading) {
    const VehicleParams& v = p_.vehicle;
    const bool ramped = !v.instant_velocity;
    const double old_speed = ramped ? robot.speed : new_speed;
    double length = p_.step * 0.5 * (old_speed + new_speed);
    const double fastest = std::max(old_speed, new_speed);
    double curvature = std::tan(v.max_steering_angle) / v.wheelbase;
    if (fastest > 0.0) curvature = std::min(curvature, v.max_yaw_rate / fastest);
    if (fastest > 0.0 && ramped) {
      curvature = std::min(curvature, v.lateral_acceleration / (fastest * fastest));
    }
    const auto mostOn = [&](double way) { return std::min(v.max_turn_per_step, curvature * way); };
    const double wanted = std::remainder(desired - robot.heading, 2.0 * M_PI);
    double turn = std::clamp(wanted, -mostOn(length), mostOn(length));

    const Point to_goal = field_.goal() - robot.position;
    const double angle =
        std::remainder(std::atan2(to_goal.y(), to_goal.x()) - robot.heading, 2.0 * M_PI);
    const double full_length = length;
    if (std::abs(angle) < 0.5 * M_PI) {
      const double to_go = to_goal.norm() * angle / std::sin(angle);
      const bool near = atMost(to_go, length);
      const bool can = atMost(std::abs(2.0 * angle), mostOn(to_go));
      const double slowed = std::max(0.0, robot.speed - v.acceleration * p_.step);
      const double least = ramped ? p_.step * 0.5 * (robot.speed + slowed) : 0.0;
      const bool brakes_in_time = least == 0.0 || atMost(least, to_go);
      if (stops_at_goal && near && can && brakes_in_time) {
        turn = 2.0 * angle;
        length = to_go;
      }
    }
    heading = robot.heading + turn;

    std::vector<Point> places;
    for (int k = 1; k <= p_.collision_checks; ++k) {
      const double t = p_.step * k / p_.collision_checks;
      const double driven = old_speed * t + 0.5 * t * t / p_.step * (new_speed - old_speed);
      const double share = full_length > 0.0 ? driven / full_length : 0.0;
      if (std::abs(turn) < 1e-6) {
        places.push_back(robot.position + share * length * unitVector(robot.heading));
        continue;
      }
      // Round the centre of the turn.
      const double radius = length / turn;
      const Point center = robot.position + radius * unitVector(robot.heading + 0.5 * M_PI);
      places.push_back(center + radius * unitVector(robot.heading + share * turn - 0.5 * M_PI));
    }
    return places;
  }

  Result advance(const Moment& moment, double desired, double new_speed, bool stops_at_goal) {
    if (isCar()) {
      double heading = desired;
      const std::vector<Point> places =
          drive(moment.robot, desired, new_speed, stops_at_goal, heading);
      return judge(moment, places, heading, new_speed);
    }
    const VehicleState& robot = moment.robot;
    const double heading = reachableHeading(robot, desired);
    const Point u(std::cos(heading), std::sin(heading));
    const Point old_velocity =
        robot.speed * Point(std::cos(robot.heading), std::sin(robot.heading));
    const Point new_velocity = new_speed * u;
    // Where the robot is `t` into the step.
    const auto moved = [&](double t) -> Point {
      if (p_.vehicle.instant_velocity) return t * new_velocity;
      return t * old_velocity + 0.5 * t * t / p_.step * (new_velocity - old_velocity);
    };
    const Point to_goal = field_.goal() - robot.position;
    const Point whole_way = moved(p_.step);
    const bool passes = atMost(to_goal.norm(), whole_way.norm());
    const bool ahead = p_.vehicle.instant_velocity ||
                       atMost(0.95 * whole_way.norm() * to_goal.norm(), whole_way.dot(to_goal));
    const bool stops = stops_at_goal && passes && ahead;
    // Where the robot is tested, the last at the end of the step.
    std::vector<Point> places;
    for (int k = 1; k <= p_.collision_checks; ++k) {
      const double share = static_cast<double>(k) / p_.collision_checks;
      places.push_back(robot.position + (stops ? Point(share * to_goal) : moved(share * p_.step)));
    }
    return judge(moment, places, heading, new_speed);
  }

  Result judge(const Moment& moment, const std::vector<Point>& places, double heading,
               double new_speed) {
    const VehicleState& robot = moment.robot;
    const Point end = places.back();
    const bool moves = (end - robot.position).norm() > 0.0;
    const Point to_goal = field_.goal() - robot.position;

    Result result;
    result.next = {end, heading, new_speed};
    result.reward =
        p_.step * (p_.reward.time + p_.reward.low_speed * (p_.vehicle.max_speed - robot.speed) /
                                        p_.vehicle.max_speed);
    const bool leaves = moves && !isInside(end);
    const bool meets = meetsSomebody(moment, places, new_speed);
    const bool hits = moves && hitsObstacle(robot.position, places);
    result.terminal = true;
    if (atMost(to_goal.norm(), p_.goal_tolerance)) {
      result.reward += p_.reward.goal;
    } else if (leaves) {
      result.reward += p_.reward.obstacle;
    } else if (meets) {
      result.reward += p_.reward.pedestrian;
    } else if (hits) {
      result.reward += p_.reward.obstacle;
    } else {
      result.terminal = false;
    }
    return result;
  }

  bool isInside(const Point& point) {
    const Point low = field_.bounds().min;
    const Point high = field_.bounds().max;
    const bool left = atMost(low.x(), point.x());
    const bool right = atMost(point.x(), high.x());
    const bool below = atMost(low.y(), point.y());
    const bool above = atMost(point.y(), high.y());
    return left && right && below && above;
  }

  bool meetsSomebody(const Moment& moment, const std::vector<Point>& places, double new_speed) {
    const double clearance = p_.pedestrianClearance();
    const bool moved = isMoving(moment.robot.speed);
    const bool moves_on = isMoving(new_speed);
    const bool at_start = atMost(nearest(moment.robot.position, moment, 0.0), clearance);
    bool on_the_way = false;
    bool at_end = false;
    for (size_t k = 0; k < places.size(); ++k) {
      const double share = (k + 1.0) / static_cast<double>(places.size());
      const bool meets = atMost(nearest(places[k], moment, share), clearance);
      (k + 1 < places.size() ? on_the_way : at_end) |= meets;
    }
    const bool brakes = moved && !p_.vehicle.instant_velocity;  // moves until it rests
    return ((moved || moves_on) && at_start) || (moves_on && (on_the_way || at_end)) ||
           (brakes && on_the_way);
  }

  // Who is inside the margin already may leave it.
  bool hitsObstacle(const Point& start, const std::vector<Point>& places) {
    if (!field_.hasObstacles()) return false;
    const double here = cell(start).clearance;
    const double allowed = here > p_.obstacleClearance() ? p_.obstacleClearance() : here - 1e-3;
    margin_ = std::min(margin_, std::abs(here - p_.obstacleClearance()));
    bool hits = false;
    for (const Point& place : places) {
      hits |= cell(place).clearance <= allowed;
      margin_ = std::min(margin_, std::abs(cell(place).clearance - allowed));
    }
    return hits;
  }

  double rollOut(Moment moment, int policy, long& steps) {
    const double slow_within = policy == 0 ? p_.near_distance : p_.bold_distance;
    const double fast_beyond = policy == 0 ? p_.far_distance : p_.bold_distance;
    double value = 0.0;
    double discount = 1.0;
    for (; moment.depth < futures_.depth(); ++moment.depth) {
      ++steps;
      const NavigationCell here = cell(moment.robot.position);
      const bool has_way = here.direction_x != 0.0F || here.direction_y != 0.0F;
      const double distance = nearest(moment.robot.position, moment, 0.0);
      const double speed_step = p_.vehicle.acceleration * p_.step;
      double speed = moment.robot.speed;
      const bool is_near = !atMost(slow_within, distance);
      const bool is_far = !atMost(distance, fast_beyond);
      if (!has_way || is_near) {
        speed = std::max(0.0, speed - speed_step);
      } else if (is_far) {
        speed = std::min(p_.vehicle.max_speed, speed + speed_step);
      }
      const double heading = has_way ? priorHeading(moment.robot.position) : moment.robot.heading;
      if (isCar()) noteTurn(moment.robot, heading);
      const Result result = advance(moment, heading, speed, has_way);
      value += discount * result.reward;
      if (result.terminal) break;
      moment.robot = result.next;
      discount *= std::pow(p_.discount_per_second, p_.step);
    }
    return value;
  }

  ModelParams p_;
  const NavigationField& field_;
  const CrowdFutures& futures_;
  double margin_ = std::numeric_limits<double>::infinity();
};

}  // namespace pomdp_crowd_nav
