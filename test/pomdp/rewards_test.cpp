// SPDX-License-Identifier: BSD-3-Clause
// Every reward term of a step of CrowdModel, by hand.
#include <gtest/gtest.h>

#include "crowd_scene.h"
#include "pomdp_crowd_nav/pomdp/crowd_model.h"

namespace pomdp_crowd_nav {
namespace {

// The paper's robot on the field with one person who stands still.
class RewardTest : public testing::Test {
 protected:
  Branch stepPastPerson(const Point& person, const VehicleState& robot, const Action& action) {
    scene_.draw({{1, person, {0.0, 0.0}, 0.0, IntentionBelief(4)}});
    return step(robot, action);
  }

  Branch step(const VehicleState& robot, const Action& action) {
    RobotState next;
    const Branch branch = model_.step(RobotState::from(robot), 0, 0, action, next);
    next_ = next;
    return branch;
  }

  // Without noise, so that who stands still stays where he is.
  static ModelParams exactModel() {
    ModelParams params = paperModel();
    params.pedestrian_noise = 0.0;
    return params;
  }

  static constexpr double kNorth = M_PI / 2.0;
  const Point far_away_{39.0, 1.0};
  CrowdScene scene_{exactModel(), {0, 1, true, 1}};
  CrowdModel model_{exactModel(), scene_.field(), scene_.futures()};
  RobotState next_;
};

TEST_F(RewardTest, TimeAndLowSpeedAreChargedBySpeedAtTheStart) {
  const Action on = Action::turnBy(0.0, 0);
  EXPECT_FLOAT_EQ(stepPastPerson(far_away_, {{4.0, 4.0}, 0.0, 2.0}, on).reward, -1.0F);
  EXPECT_FLOAT_EQ(stepPastPerson(far_away_, {{4.0, 4.0}, 0.0, 1.0}, on).reward, -1.5F);
  EXPECT_FLOAT_EQ(stepPastPerson(far_away_, {{4.0, 4.0}, 0.0, 0.0}, on).reward, -2.0F);
  const Action faster = Action::turnBy(0.0, 1);
  EXPECT_FLOAT_EQ(stepPastPerson(far_away_, {{4.0, 4.0}, 0.0, 0.0}, faster).reward, -2.0F);
  EXPECT_FLOAT_EQ(next_.x, 5.0F) << "the new speed holds from the start of the step";
}

TEST_F(RewardTest, SuddenBrakeCostsAndStops) {
  const Branch branch = stepPastPerson(far_away_, {{4.0, 4.0}, 0.0, 2.0}, Action::suddenBrake());
  EXPECT_FLOAT_EQ(branch.reward, -11.0F);
  EXPECT_FALSE(branch.terminal);
  EXPECT_EQ(next_.speed, 0.0F);
  EXPECT_FLOAT_EQ(next_.x, 4.0F);
}

TEST_F(RewardTest, TheGoalIsPaidInTheStepAfterArrival) {
  const Point goal = scene_.field().goal();
  const Branch arrives =
      stepPastPerson(far_away_, {goal - Point(1.5, 0.0), 0.0, 2.0}, Action::followPrior(0));
  EXPECT_FLOAT_EQ(arrives.reward, -1.0F);
  EXPECT_FALSE(arrives.terminal);
  EXPECT_NEAR(next_.x, goal.x(), 1e-5) << "the step along the prior ends on the goal";
  const Branch after =
      stepPastPerson(far_away_, {goal - Point(0.9, 0.0), 0.0, 1.0}, Action::turnBy(0.0, 0));
  EXPECT_FLOAT_EQ(after.reward, 1000.0F - 1.5F);
  EXPECT_TRUE(after.terminal);
  const Branch short_of_it =
      stepPastPerson(far_away_, {goal - Point(1.1, 0.0), 0.0, 1.0}, Action::turnBy(0.0, 0));
  EXPECT_FALSE(short_of_it.terminal);
}

TEST_F(RewardTest, AtTheGoalNobodyIsInTheWay) {
  const Point goal = scene_.field().goal();
  const Branch branch = stepPastPerson(goal, {goal, 0.0, 2.0}, Action::turnBy(0.0, 0));
  EXPECT_FLOAT_EQ(branch.reward, 1000.0F - 1.0F);
}

TEST_F(RewardTest, LeavingTheFieldIsAnObstacle) {
  const Branch branch = stepPastPerson(far_away_, {{0.5, 4.0}, M_PI, 1.0}, Action::turnBy(0.0, 0));
  EXPECT_FLOAT_EQ(branch.reward, -100.0F - 1.5F);
  EXPECT_TRUE(branch.terminal);
  const Branch stays = stepPastPerson(far_away_, {{0.5, 4.0}, M_PI, 0.0}, Action::turnBy(0.0, 0));
  EXPECT_FALSE(stays.terminal);
}

// Driving 2 m east from (10, 4): a person 2 m or less off at the start, half way, or at the end.
TEST_F(RewardTest, PeopleAreMetAtTheStartHalfWayAndAtTheEnd) {
  const VehicleState robot{{10.0, 4.0}, 0.0, 2.0};
  const Action on = Action::turnBy(0.0, 0);
  const auto collides = [&](const Point& person) {
    const Branch branch = stepPastPerson(person, robot, on);
    EXPECT_FLOAT_EQ(branch.reward, branch.terminal ? -101.0F : -1.0F);
    return branch.terminal;
  };
  EXPECT_TRUE(collides({8.05, 4.0})) << "1.95 m behind at the start";
  EXPECT_FALSE(collides({7.95, 4.0})) << "2.05 m behind at the start";
  EXPECT_TRUE(collides({11.0, 5.95})) << "1.95 m abeam half way, 2.19 m before and after";
  EXPECT_FALSE(collides({11.0, 6.05})) << "2.05 m abeam half way";
  EXPECT_TRUE(collides({13.95, 4.0})) << "1.95 m ahead at the end";
  EXPECT_FALSE(collides({14.05, 4.0})) << "2.05 m ahead at the end";
}

// Driving 2 m east from (10, 4) past somebody who stands 1.99 m abeam of a fifth of the way.
TEST_F(RewardTest, MoreTestsOfAStepMeetMorePeople) {
  ModelParams params = exactModel();
  const Point person(10.4, 5.99);
  scene_.draw({{1, person, {0.0, 0.0}, 0.0, IntentionBelief(4)}});
  const auto collides = [&](int checks) {
    params.collision_checks = checks;
    const CrowdModel model(params, scene_.field(), scene_.futures());
    RobotState next;
    return model.step(RobotState::from({{10.0, 4.0}, 0.0, 2.0}), 0, 0, Action::turnBy(0.0, 0), next)
        .terminal;
  };
  EXPECT_FALSE(collides(2));
  EXPECT_FALSE(collides(3));
  EXPECT_TRUE(collides(5));
}

TEST_F(RewardTest, WalkersAreMetWhereTheyWillBe) {
  // Walks from (16, 4) toward (0, 0) and ends nearly 1 m nearer; the robot ends on (12, 4).
  scene_.draw({{1, {14.9, 4.0}, {0.0, 0.0}, 1.0, IntentionBelief(4)}});
  const auto* end = scene_.futures().at(0, 1);
  const double distance = (Point(end->x, end->y) - Point(12.0, 4.0)).norm();
  const Branch branch = step({{10.0, 4.0}, 0.0, 2.0}, Action::turnBy(0.0, 0));
  EXPECT_EQ(branch.terminal, distance <= 2.0);
}

TEST_F(RewardTest, AStandingRobotIsNotToBlame) {
  const Point close(10.5, 4.0);
  EXPECT_FALSE(stepPastPerson(close, {{10.0, 4.0}, 0.0, 0.0}, Action::turnBy(0.0, 0)).terminal);
  EXPECT_TRUE(stepPastPerson(close, {{10.0, 4.0}, 0.0, 0.0}, Action::turnBy(0.0, 1)).terminal)
      << "driving off next to somebody";
  EXPECT_TRUE(stepPastPerson(close, {{10.0, 4.0}, 0.0, 1.0}, Action::suddenBrake()).terminal)
      << "whatever the action";
  EXPECT_FALSE(stepPastPerson({12.5, 4.0}, {{10.0, 4.0}, 0.0, 2.0}, Action::suddenBrake()).terminal)
      << "an instant base stops at once";
}

TEST_F(RewardTest, ObstaclesAreMetAtTheirClearance) {
  // The circle at (12, 15) has a radius of 2 m; the robot keeps 3 m from its surface.
  const Action on = Action::turnBy(0.0, 0);
  const Branch hits = stepPastPerson(far_away_, {{12.0, 8.5}, kNorth, 2.0}, on);
  EXPECT_FLOAT_EQ(hits.reward, -101.0F);
  EXPECT_TRUE(hits.terminal);
  EXPECT_FALSE(stepPastPerson(far_away_, {{12.0, 7.5}, kNorth, 2.0}, on).terminal);
}

TEST_F(RewardTest, WhoIsInsideTheMarginMayLeaveIt) {
  const Action on = Action::turnBy(0.0, 0);
  EXPECT_FALSE(stepPastPerson(far_away_, {{12.0, 11.0}, -kNorth, 1.0}, on).terminal) << "out";
  EXPECT_TRUE(stepPastPerson(far_away_, {{12.0, 11.0}, kNorth, 1.0}, on).terminal) << "in";
  EXPECT_FALSE(stepPastPerson(far_away_, {{12.0, 11.0}, kNorth, 0.0}, on).terminal) << "stay";
}

TEST_F(RewardTest, TheFirstCauseCounts) {
  ModelParams params = exactModel();
  params.reward.pedestrian = -70.0;
  params.reward.obstacle = -30.0;
  const CrowdModel model(params, scene_.field(), scene_.futures());
  const Action on = Action::turnBy(0.0, 0);
  RobotState next;
  const auto reward = [&](const Point& person, const VehicleState& robot) {
    scene_.draw({{1, person, {0.0, 0.0}, 0.0, IntentionBelief(4)}});
    return model.step(RobotState::from(robot), 0, 0, on, next).reward;
  };
  EXPECT_FLOAT_EQ(reward({12.0, 9.5}, {{12.0, 8.5}, kNorth, 2.0}), -71.0F)
      << "a person before an obstacle";
  EXPECT_FLOAT_EQ(reward({0.5, 4.0}, {{0.5, 4.0}, M_PI, 2.0}), -31.0F)
      << "the border before a person";
}

}  // namespace
}  // namespace pomdp_crowd_nav
