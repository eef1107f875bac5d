// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "command_loop_test.h"

namespace pomdp_crowd_nav {
namespace {

class TurnAtTheGoal : public CommandLoopTest {
 protected:
  static PlannerNodeParams turningParams() {
    PlannerNodeParams turning = params();
    turning.navigation.yaw_goal_tolerance = 0.1;
    return turning;
  }
  TurnAtTheGoal() : CommandLoopTest(turningParams()) {}
};

TEST_F(TurnAtTheGoal, TurnsInPlaceToTheHeadingOfTheGoal) {
  drive_.inputs.robot->pose.position = Point(19.9, 0.0);
  run(8.0);
  ASSERT_TRUE(finished_);
  EXPECT_NEAR(drive_.inputs.robot->pose.heading, 2.0, 0.15);
  EXPECT_NEAR(drive_.inputs.robot->pose.position.x(), 19.9, 1e-6);
}

TEST_F(TurnAtTheGoal, SlowTurnIsGivenTheTimeToComeToRest) {
  drive_.inputs.robot->pose.position = Point(19.9, 0.0);
  double& heading = drive_.inputs.robot->pose.heading;
  const double begin = now_;
  for (int i = 0; i < 400 && !finished_; ++i) {
    const double before = heading;
    run(0.05);
    heading = before + 0.25 * wrapAngle(heading - before);
  }
  ASSERT_TRUE(finished_);
  EXPECT_EQ(finished_->outcome, Outcome::kReached) << finished_->text;
  EXPECT_NEAR(heading, 2.0, 0.11);
  EXPECT_GT(now_ - begin, 6.0);
}

TEST_F(TurnAtTheGoal, BaseThatDoesNotTurnFails) {
  drive_.inputs.robot->pose.position = Point(19.9, 0.0);
  for (int i = 0; i < 400 && !finished_; ++i) {
    run(0.05);
    drive_.inputs.robot->pose.heading = drive_.inputs.robot->yaw_rate = 0.0;
  }
  expectEnd(Outcome::kFailed, "failed: the base is 2.00 rad off the heading of the goal");
}

TEST_F(TurnAtTheGoal, CancelEndsTheTurn) {
  drive_.inputs.robot->pose.position = Point(19.9, 0.0);
  run(1.0);
  ASSERT_GT(drive_.inputs.robot->yaw_rate, 0.0);
  cancelTrip(now_, drive_);
  run(2.0);
  EXPECT_EQ(drive_.inputs.robot->yaw_rate, 0.0);
  EXPECT_LT(drive_.inputs.robot->pose.heading, 1.5);
  ASSERT_TRUE(finished_);
  EXPECT_EQ(finished_->outcome, Outcome::kCancelled);
}

TEST_F(TurnAtTheGoal, PauseHoldsTheTurn) {
  drive_.inputs.robot->pose.position = Point(19.9, 0.0);
  run(1.0);
  drive_.paused = true;
  run(2.0);
  EXPECT_EQ(drive_.inputs.robot->yaw_rate, 0.0);
  const double heading = drive_.inputs.robot->pose.heading;
  run(20.0);
  EXPECT_EQ(drive_.inputs.robot->pose.heading, heading);
  EXPECT_FALSE(finished_);
  drive_.paused = false;
  run(8.0);
  ASSERT_TRUE(finished_);
  EXPECT_EQ(finished_->outcome, Outcome::kReached);
  EXPECT_NEAR(drive_.inputs.robot->pose.heading, 2.0, 0.15);
}

}  // namespace
}  // namespace pomdp_crowd_nav
