// SPDX-License-Identifier: BSD-3-Clause
// What every planner must do, run over every name in the table with every vehicle that it drives,
// instant and ramped.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

#include "pomdp_crowd_nav/planner/planner_factory.h"

namespace pomdp_crowd_nav {
namespace {

const std::vector<Point> kCorners{{0.0, 0.0}, {0.0, 30.0}, {40.0, 30.0}, {40.0, 0.0}};

// A disc beside the straight way, so that planners that ignore the map arrive as well.
StaticMap discMap() {
  StaticMap::Obstacles obstacles;
  obstacles.circles = {{{20.0, 4.0}, 3.0}};
  return StaticMap({{0.0, 0.0}, {40.0, 30.0}}, obstacles);
}

PlannerParams instantParams() {
  PlannerParams params;
  params.search.scenarios = 30;
  params.model.horizon = 40.0;
  return params;
}

PlannerParams rampedParams() {
  PlannerParams params = instantParams();
  params.model.vehicle.instant_velocity = false;
  params.model.vehicle.max_speed = 1.5;
  params.model.vehicle.lateral_acceleration = 0.8;
  params.model.vehicle.brake_deceleration = 1.5;
  params.model.vehicle.radius = 0.5;
  params.model.step = 0.5;
  params.model.beyond_horizon = BeyondHorizon::kFreeDrive;
  return params;
}

PersonBelief person(std::int64_t id, const Point& position, const Point& velocity = {0.0, 0.0}) {
  return {id, position, velocity, 1.0, IntentionBelief(4)};
}

CrowdBelief crowdAround(const Point& robot) {
  return {1.0,
          {person(1, robot + Point(6.0, 0.5), {-1.0, 0.0}), person(4, robot + Point(3.0, 4.0)),
           person(6, robot + Point(-4.0, 1.0)), person(9, robot + Point(9.0, -3.0)),
           person(12, robot + Point(2.6, -2.0)), person(13, robot + Point(12.0, 2.0)),
           person(20, robot + Point(14.0, -1.0))}};
}

struct Case {
  std::string planner;
  VehicleKind vehicle;
  bool is_instant;
};

std::vector<Case> everyCase() {
  std::vector<Case> cases;
  for (const std::string& planner : plannerNames()) {
    for (const VehicleKind vehicle : {VehicleKind::kHolonomic, VehicleKind::kCar}) {
      if (!drives(planner, vehicle)) continue;
      for (const bool is_instant : {false, true}) cases.push_back({planner, vehicle, is_instant});
    }
  }
  return cases;
}

std::string nameOf(const Case& c) {
  return c.planner + (c.vehicle == VehicleKind::kCar ? "_car" : "") +
         (c.is_instant ? "_instant" : "_ramped");
}

class PlannerContract : public testing::TestWithParam<Case> {
 protected:
  std::unique_ptr<Planner> make(const Point& goal = {36.0, 20.0}) const {
    return makePlanner(GetParam().planner, {map_, goal, kCorners}, params_);
  }

  void expectPossible(const Decision& decision, const VehicleState& vehicle) const {
    const VehicleParams& limits = params_.model.vehicle;
    const StepMotion& motion = decision.motion;
    ASSERT_TRUE(motion.end_velocity.allFinite());
    ASSERT_TRUE(std::isfinite(motion.end_heading));
    EXPECT_EQ(motion.start, vehicle.position);
    EXPECT_DOUBLE_EQ(motion.duration, params_.model.step);
    EXPECT_LE(motion.end_velocity.norm(), limits.max_speed + 1e-6);
    if (limits.kind == VehicleKind::kCar) expectArcs(motion, vehicle);
    if (limits.instant_velocity) return;
    EXPECT_LE((motion.start_velocity - vehicle.velocity()).norm(), 1e-9);
    const double step = motion.duration;
    const double end_speed = motion.end_velocity.norm();
    EXPECT_LE(end_speed, vehicle.speed + limits.acceleration * step + 1e-6);
    EXPECT_GE(end_speed, vehicle.speed - limits.brake_deceleration * step - 1e-6);
    if (limits.kind == VehicleKind::kCar) return;
    const double chord = (unitVector(motion.end_heading) - unitVector(vehicle.heading)).norm();
    EXPECT_LE(vehicle.speed * chord, limits.lateral_acceleration * step + 1e-6);
  }

  // A car drives where it faces, turns no tighter than it can, and keeps its heading at rest. On a
  // path it may turn by more in a step than the action space of the others has it.
  void expectArcs(const StepMotion& motion, const VehicleState& vehicle) const {
    const VehicleParams& limits = params_.model.vehicle;
    if (motion.legs.empty()) {
      EXPECT_EQ(motion.end_velocity.norm(), 0.0);
      EXPECT_NEAR(wrapAngle(motion.end_heading - vehicle.heading), 0.0, 1e-9);
      return;
    }
    const bool on_path = GetParam().planner == "1d_astar";
    if (!on_path) {
      ASSERT_EQ(motion.legs.size(), 1U);
      EXPECT_LE(std::abs(motion.legs.front().turn), limits.max_turn_per_step + 1e-9);
    }
    const double end_speed = motion.end_velocity.norm();
    const double fastest = limits.instant_velocity ? end_speed : std::max(vehicle.speed, end_speed);
    double heading = vehicle.heading;
    for (const PathLeg& leg : motion.legs) {
      EXPECT_NEAR(wrapAngle(leg.heading - heading), 0.0, 1e-9);
      const double curvature = std::abs(leg.turn) / leg.length;
      EXPECT_LE(curvature, maxCurvature(limits, fastest) + 1e-9);
      heading += leg.turn;
    }
    EXPECT_NEAR(wrapAngle(heading - motion.end_heading), 0.0, 1e-9);
    EXPECT_NEAR(motion.end_velocity.dot(unitVector(motion.end_heading)), end_speed, 1e-9);
  }

  static PlannerParams params() {
    PlannerParams params = GetParam().is_instant ? instantParams() : rampedParams();
    if (GetParam().vehicle == VehicleKind::kHolonomic) return params;
    params.model.vehicle.kind = VehicleKind::kCar;
    params.model.vehicle.max_yaw_rate = 3.2;
    params.model.collision_checks = 5;
    if (params.model.vehicle.instant_velocity) params.model.vehicle.max_speed = 4.0;
    return params;
  }

  StaticMap map_ = discMap();
  PlannerParams params_ = params();
};

TEST_P(PlannerContract, ReachesAGoalAloneInLockstep) {
  const auto planner = make();
  VehicleState robot{{3.0, 14.0}, 0.0, 0.0};
  double clearance = map_.clearance(robot.position);
  double time = 0.0;
  while ((robot.position - Point(36.0, 20.0)).norm() > params_.model.goal_tolerance) {
    ASSERT_LT(time, 60.0) << "at " << robot.position.transpose();
    const Decision decision = planner->decide({robot, {}}, SearchLimit::trials(15));
    expectPossible(decision, robot);
    robot = decision.motion.end();
    time += params_.model.step;
    clearance = std::min(clearance, map_.clearance(robot.position));
    ASSERT_TRUE(map_.bounds().contains(robot.position));
  }
  const double shortest = 33.6 / params_.model.vehicle.max_speed;
  EXPECT_LT(time, 1.3 * shortest + 4.0);
  EXPECT_GT(clearance, params_.model.vehicle.radius);
}

TEST_P(PlannerContract, DecisionsAreLegalAndPlansBeginAtTheSituation) {
  const auto planner = make();
  for (const double speed : {0.0, 0.5, params_.model.vehicle.max_speed}) {
    for (const double heading : {0.0, 2.0, -3.1}) {
      const VehicleState robot{{10.0, 14.0}, heading, speed};
      const Decision decision =
          planner->decide({robot, crowdAround(robot.position)}, SearchLimit::trials(25));
      expectPossible(decision, robot);
      ASSERT_GE(decision.plan.size(), 2U);
      EXPECT_LE((decision.plan[0].position - robot.position).norm(), 1e-5);
      EXPECT_NEAR(decision.plan[0].speed, speed, 1e-5);
      const VehicleState end = decision.motion.end();
      EXPECT_LE((decision.plan[1].position - end.position).norm(), 1e-4)
          << "the plan's first step is the motion";
      EXPECT_NEAR(decision.plan[1].speed, end.speed, 1e-4);
      EXPECT_EQ(decision.search.bound_violations, 0);
      EXPECT_LE(decision.search.lower_bound, decision.search.upper_bound);
      EXPECT_GT(decision.wall_time, 0.0);
      EXPECT_LE(decision.attended.size(), static_cast<size_t>(params_.pedestrians));
    }
  }
}

TEST_P(PlannerContract, SameSituationsSameDecisions) {
  const auto planner = make();
  const auto twin = make();
  const VehicleState robot{{10.0, 14.0}, 0.3, 1.0};
  for (int i = 0; i < 3; ++i) {
    const Situation situation{robot, crowdAround(robot.position)};
    const Decision a = planner->decide(situation, SearchLimit::trials(40));
    const Decision b = twin->decide(situation, SearchLimit::trials(40));
    EXPECT_EQ(a.action, b.action);
    EXPECT_EQ(a.search.lower_bound, b.search.lower_bound);
    EXPECT_EQ(a.search.upper_bound, b.search.upper_bound);
    EXPECT_EQ(a.search.belief_nodes, b.search.belief_nodes);
    EXPECT_EQ(a.search.model_steps, b.search.model_steps);
    EXPECT_EQ(a.plan.size(), b.plan.size());
    EXPECT_EQ(a.attended, b.attended);
  }
}

TEST_P(PlannerContract, DecidesWhoeverIsWhere) {
  const auto planner = make();
  const VehicleState robot{{10.0, 14.0}, 0.0, 1.0};
  CrowdBelief strange;
  for (int i = 0; i < 30; ++i) strange.people.push_back(person(i, robot.position));
  expectPossible(planner->decide({robot, strange}, SearchLimit::trials(10)), robot);
  strange.people = {person(1, {0.0, 0.0}), person(2, {40.0, 30.0}), person(3, {-5.0, 50.0})};
  expectPossible(planner->decide({robot, strange}, SearchLimit::trials(10)), robot);
  const Decision alone = planner->decide({robot, {}}, SearchLimit::trials(10));
  expectPossible(alone, robot);
  EXPECT_TRUE(alone.attended.empty());
}

TEST_P(PlannerContract, DecidesWhereverTheRobotIs) {
  const auto planner = make();
  for (const Point& place : {Point(0.0, 0.0), Point(40.0, 30.0), Point(-3.0, 5.0), Point(20.0, 4.0),
                             Point(36.0, 20.0), Point(35.9, 20.0)}) {
    for (const double speed : {0.0, params_.model.vehicle.max_speed}) {
      const VehicleState robot{place, 1.0, speed};
      expectPossible(planner->decide({robot, crowdAround(place)}, SearchLimit::trials(10)), robot);
    }
  }
}

// Odometry may report a little more than the limit.
TEST_P(PlannerContract, SlowsARobotThatIsTooFast) {
  const auto planner = make();
  const double limit = params_.model.vehicle.max_speed;
  const VehicleState robot{{10.0, 14.0}, 0.2, 1.1 * limit};
  const Decision decision = planner->decide({robot, {}}, SearchLimit::trials(20));
  EXPECT_LE(decision.motion.end().speed, limit + 1e-6);
  EXPECT_EQ(decision.search.bound_violations, 0);
}

TEST_P(PlannerContract, ADeadlineInThePastIsNoExcuse) {
  const auto planner = make();
  const VehicleState robot{{10.0, 14.0}, 0.2, 0.5};
  const Decision decision =
      planner->decide({robot, crowdAround(robot.position)},
                      SearchLimit::until(SearchLimit::Clock::now() - std::chrono::seconds(1)));
  expectPossible(decision, robot);
  EXPECT_EQ(decision.search.stop, SearchStop::kDeadline);
}

TEST_P(PlannerContract, TheViewIsOneTreeOfAtMostSoManyEdges) {
  const auto planner = make();
  EXPECT_TRUE(planner->viewTree({100}).edges.empty()) << "before any decision";
  const VehicleState robot{{10.0, 14.0}, 0.2, 0.5};
  planner->decide({robot, crowdAround(robot.position)}, SearchLimit::trials(60));
  for (const int limit : {0, 1, 7, 40, 100000}) {
    const TreeView view = planner->viewTree({limit});
    ASSERT_LE(view.edges.size(), static_cast<size_t>(limit));
    std::set<std::pair<double, double>> reached;
    reached.insert(
        {static_cast<float>(robot.position.x()), static_cast<float>(robot.position.y())});
    for (const TreeEdge& edge : view.edges) {
      ASSERT_TRUE(reached.count({edge.from.x(), edge.from.y()}) == 1) << "limit " << limit;
      reached.insert({edge.to.x(), edge.to.y()});
      EXPECT_GT(edge.weight, 0.0F);
      EXPECT_LE(edge.weight, 1.0F);
      EXPECT_GE(edge.depth, 1);
      EXPECT_TRUE(std::isfinite(edge.value));
    }
    if (limit > 0) {
      EXPECT_FALSE(view.edges.empty());
    }
    for (const auto& rollout : view.rollouts) EXPECT_GE(rollout.size(), 2U);
  }
  EXPECT_TRUE(planner->viewTree({-5}).edges.empty());
}

TEST_P(PlannerContract, TheViewEndsAtTheDepthThatIsAskedFor) {
  const auto planner = make();
  const VehicleState robot{{10.0, 14.0}, 0.2, 0.5};
  planner->decide({robot, crowdAround(robot.position)}, SearchLimit::trials(60));
  const auto depthOf = [](const TreeView& view) {
    int depth = 0;
    for (const TreeEdge& edge : view.edges) depth = std::max(depth, edge.depth);
    return depth;
  };
  const int deepest = depthOf(planner->viewTree({100000}));
  ASSERT_GT(deepest, 0);
  EXPECT_EQ(depthOf(planner->viewTree({100000, 2})), std::min(deepest, 2));
  EXPECT_EQ(depthOf(planner->viewTree({100000, 100})), deepest);
}

TEST_P(PlannerContract, TheGuidanceIsThatOfThePlannerAndOutlivesIt) {
  auto planner = make();
  const Point place(3.0, 14.0);
  const NavigationCell cell = planner->guidanceAt(place);
  const Guidance guidance = planner->guidance();
  planner.reset();
  if (!guidance.field) GTEST_SKIP() << "it keeps none";
  EXPECT_EQ(guidance.field->at(3.0F, 14.0F).distance_to_goal, cell.distance_to_goal);
  if (guidance.prior) {
    EXPECT_EQ(guidance.prior->goal(), guidance.field->goal());
  }
}

TEST_P(PlannerContract, TheGlobalPathLeadsToTheGoal) {
  const auto planner = make();
  const std::vector<Point> path = planner->globalPath({3.0, 14.0});
  ASSERT_GE(path.size(), 2U);
  EXPECT_EQ(path.front(), Point(3.0, 14.0));
  EXPECT_EQ(path.back(), Point(36.0, 20.0));
  for (size_t i = 1; i < path.size(); ++i) EXPECT_LE((path[i] - path[i - 1]).norm(), 1.0);
  EXPECT_GE(planner->globalPath({36.0, 20.0}).size(), 1U);
}

TEST_P(PlannerContract, TheGlobalPathStaysOnTheFieldToAGoalOnTheBorder) {
  const auto planner = make({40.0, 20.0});
  for (double x = 39.01; x < 40.0; x += 0.07) {
    for (const double y : {3.0, 28.0}) {
      const std::vector<Point> path = planner->globalPath({x, y});
      EXPECT_EQ(path.back(), Point(40.0, 20.0)) << "from " << x << ' ' << y;
      for (const Point& place : path) ASSERT_TRUE(map_.bounds().contains(place));
    }
  }
}

TEST_P(PlannerContract, RefusesABadGoal) {
  EXPECT_THROW(make({41.0, 20.0}), std::invalid_argument);
  EXPECT_THROW(make({20.0, 4.5}), std::invalid_argument);
  EXPECT_THROW(make({std::nan(""), 4.5}), std::invalid_argument);
}

INSTANTIATE_TEST_SUITE_P(EveryName, PlannerContract, testing::ValuesIn(everyCase()),
                         [](const auto& test) { return nameOf(test.param); });

std::string messageFor(const std::string& name, const std::vector<Point>& destinations,
                       const PlannerParams& params = PlannerParams()) {
  const StaticMap map = discMap();
  try {
    makePlanner(name, {map, {36.0, 20.0}, destinations}, params);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "accepted";
}

TEST(PlannerFactory, AnUnknownNameListsTheKnown) {
  const std::string message = messageFor("3d_warp", kCorners);
  EXPECT_NE(message.find("'3d_warp'"), std::string::npos) << message;
  ASSERT_FALSE(plannerNames().empty());
  for (const std::string& name : plannerNames()) {
    EXPECT_NE(message.find(name), std::string::npos) << message;
  }
}

TEST(PlannerFactory, EachPlannerDrivesItsVehicle) {
  PlannerParams car;
  car.model.vehicle.kind = VehicleKind::kCar;
  for (const std::string& name : plannerNames()) {
    EXPECT_EQ(messageFor(name, kCorners) == "accepted", drives(name, VehicleKind::kHolonomic));
    EXPECT_EQ(messageFor(name, kCorners, car) == "accepted", drives(name, VehicleKind::kCar));
  }
  EXPECT_EQ(messageFor("2d_fmm", kCorners, car).find("planner must be one of 2d_nhv"), 0U)
      << messageFor("2d_fmm", kCorners, car);
  const std::string message = messageFor("2d_nhv", kCorners);
  EXPECT_NE(message.find("for vehicle 'holonomic', got '2d_nhv'"), std::string::npos) << message;
}

TEST(PlannerFactory, RefusesACarThatCannotDriveAPath) {
  PlannerParams car;
  car.model.vehicle.kind = VehicleKind::kCar;
  car.model.vehicle.max_speed = 4.0;
  car.model.vehicle.instant_velocity = false;
  EXPECT_EQ(messageFor("1d_astar", kCorners, car),
            "max_steering_angle, wheelbase, max_vel_theta, acc_lim_y must allow a car of planner "
            "'1d_astar' to turn by 0.087 rad on 1 m at max_vel_trans, got 0.062");
  car.model.vehicle.lateral_acceleration = 2.0;
  EXPECT_EQ(messageFor("1d_astar", kCorners, car), "accepted");
  car.model.vehicle.instant_velocity = true;
  car.model.vehicle.wheelbase = 10.0;
  EXPECT_EQ(messageFor("1d_astar", kCorners, car),
            "max_steering_angle, wheelbase, max_vel_theta must allow a car of planner '1d_astar' "
            "to turn by 0.087 rad on 1 m at max_vel_trans, got 0.079");
  car.model.vehicle.kind = VehicleKind::kHolonomic;
  EXPECT_EQ(messageFor("1d_astar", kCorners, car), "accepted");
}

TEST(PlannerFactory, RefusesWhatNoPlannerCanUse) {
  EXPECT_NE(messageFor("2d_fmm", {}).find("destinations"), std::string::npos);
  PlannerParams params;
  params.pedestrians = -1;
  EXPECT_EQ(messageFor("2d_fmm", kCorners, params),
            "attended_pedestrians must be between 0 and 64, got -1");
}

}  // namespace
}  // namespace pomdp_crowd_nav
