// SPDX-License-Identifier: BSD-3-Clause
#include "command_loop_test.h"

#include <cmath>

namespace pomdp_crowd_nav {
namespace {

TEST_F(CommandLoopTest, FollowsTheMotion) {
  cruise();
  EXPECT_NEAR(speed(), 0.8, 1e-9);
  EXPECT_EQ(stopCause(drive_, loop_.limits(), now_), StopCause::kNone);
}

TEST_F(CommandLoopTest, SilentInputsBrakeTheBase) {
  cruise();
  is_silent_ = true;
  run(2.0);
  EXPECT_EQ(speed(), 0.0);
  EXPECT_EQ(stopCause(drive_, loop_.limits(), now_), StopCause::kNoOdometry);
  EXPECT_EQ(toStatus(drive_, loop_.limits(), now_).state, PlannerStatus::WAITING_FOR_INPUT);
}

TEST_F(CommandLoopTest, CausesAreToldApart) {
  drive_.inputs.robot.reset();
  EXPECT_EQ(missingInput(drive_.inputs, loop_.limits(), now_), StopCause::kNoOdometry);
  drive_.inputs.odometry_traffic.noteRefusal(MessageFault::kNotFinite, now_);
  EXPECT_EQ(missingInput(drive_.inputs, loop_.limits(), now_), StopCause::kOdometryRefused);
  EXPECT_NE(toStatus(drive_, loop_.limits(), now_).stop_cause.find("not finite"),
            std::string::npos);
  drive_.inputs.robot = RobotReading();
  refreshInputs();
  drive_.inputs.tracks_at = now_ - 5.0;
  EXPECT_EQ(missingInput(drive_.inputs, loop_.limits(), now_), StopCause::kNoPeople);
  drive_.inputs.jump_at = now_;
  drive_.inputs.jump = StopCause::kClockJumped;
  EXPECT_EQ(missingInput(drive_.inputs, loop_.limits(), now_), StopCause::kClockJumped);
  drive_.inputs.map.reset();
  EXPECT_EQ(missingInput(drive_.inputs, loop_.limits(), now_), StopCause::kNoMap);
}

TEST_F(CommandLoopTest, PausedBaseBrakes) {
  cruise();
  drive_.paused = true;
  run(2.0);
  EXPECT_EQ(speed(), 0.0);
  EXPECT_EQ(toStatus(drive_, loop_.limits(), now_).state, PlannerStatus::PAUSED);
}

TEST_F(CommandLoopTest, PersonInTheWayIsASuddenBrakeOnce) {
  cruise();
  const Point ahead = drive_.inputs.robot->pose.position + Point(1.2, 0.0);
  drive_.inputs.tracks.tracks.push_back({5, ahead, Point(0.0, 0.0)});
  run(2.0);
  EXPECT_EQ(speed(), 0.0);
  EXPECT_EQ(drive_.counts.sudden_brakes, 1u);
  EXPECT_EQ(stopCause(drive_, loop_.limits(), now_), StopCause::kEmergency);
}

TEST_F(CommandLoopTest, ReachedGoalIsReportedAtRestAndThenNobodyCommandsTheBase) {
  cruise();
  drive_.inputs.robot->pose.position = Point(19.9, 0.0);
  run(0.1);
  EXPECT_FALSE(drive_.hasGoal());
  EXPECT_FALSE(finished_) << "the base still moves";
  const CommandLoop::Tick last = run(4.0);
  ASSERT_TRUE(finished_);
  EXPECT_EQ(finished_->outcome, Outcome::kReached);
  EXPECT_EQ(speed(), 0.0);
  EXPECT_FALSE(last.command);
}

TEST_F(CommandLoopTest, ObstacleOfANewMapIsBrakedFor) {
  cruise();
  drive_.planned_map = drive_.inputs.map;
  run(0.5);
  EXPECT_GT(speed(), 0.7);
  StaticMap::Obstacles obstacles;
  const double ahead = drive_.inputs.robot->pose.position.x() + 1.8;
  obstacles.circles.push_back({Point(ahead + 1.0, 0.0), 1.0});
  drive_.inputs.map =
      std::make_shared<const StaticMap>(Bounds{Point(-50.0, -50.0), Point(50.0, 50.0)}, obstacles);
  run(3.0);
  EXPECT_EQ(speed(), 0.0);
  EXPECT_EQ(stopCause(drive_, loop_.limits(), now_), StopCause::kObstacle);
  EXPECT_GE(drive_.inputs.map->clearance(drive_.inputs.robot->pose.position), 0.5);
}

// The new planner stands, but the base still follows what the old one has decided.
TEST_F(CommandLoopTest, ANewMapIsWatchedUntilAMotionThatKnowsItIsFollowed) {
  cruise();
  StaticMap::Obstacles obstacles;
  const double ahead = drive_.inputs.robot->pose.position.x() + 1.8;
  obstacles.circles.push_back({Point(ahead + 1.0, 0.0), 1.0});
  drive_.inputs.map =
      std::make_shared<const StaticMap>(Bounds{Point(-50.0, -50.0), Point(50.0, 50.0)}, obstacles);
  drive_.planned_map = drive_.inputs.map;
  drive_.planned_from = now_ + 10.0;
  run(3.0);
  EXPECT_EQ(speed(), 0.0);
  EXPECT_EQ(stopCause(drive_, loop_.limits(), now_), StopCause::kObstacle);
}

TEST_F(CommandLoopTest, ReactionTimeThatIsChangedInFlightCountsForMapsToo) {
  NavigationParams changed = params().navigation;
  changed.emergency.reaction_time = 2.0;
  loop_.setParams(changed);
  cruise();
  drive_.planned_map = drive_.inputs.map;
  StaticMap::Obstacles obstacles;
  const double ahead = drive_.inputs.robot->pose.position.x() + 2.2;
  obstacles.circles.push_back({Point(ahead + 1.0, 0.0), 1.0});
  drive_.inputs.map =
      std::make_shared<const StaticMap>(Bounds{Point(-50.0, -50.0), Point(50.0, 50.0)}, obstacles);
  run(0.3);
  EXPECT_EQ(stopCause(drive_, loop_.limits(), now_), StopCause::kObstacle);
}

TEST_F(CommandLoopTest, ACancelThatComesLateEndsNoNewerTrip) {
  ASSERT_TRUE(beginTrip({2, Pose{Point(30.0, 0.0), 0.0}}, now_, drive_));
  cancelTrip(1, now_, drive_);
  EXPECT_EQ(drive_.goal.number, 2);
  EXPECT_FALSE(drive_.ending);
  cancelTrip(2, now_, drive_);
  EXPECT_FALSE(drive_.hasGoal());
  ASSERT_TRUE(drive_.ending);
  EXPECT_EQ(drive_.ending->goal.number, 2);
  EXPECT_EQ(drive_.ending->outcome, Outcome::kCancelled);
}

TEST_F(CommandLoopTest, AnOlderTripDoesNotBeginAfterANewerOne) {
  ASSERT_TRUE(beginTrip({3, Pose{Point(30.0, 0.0), 0.0}}, now_, drive_));
  EXPECT_FALSE(beginTrip({2, Pose{Point(10.0, 0.0), 0.0}}, now_, drive_));
  EXPECT_EQ(drive_.goal.number, 3);
}

TEST_F(CommandLoopTest, NoTripBeginsWhileTheNodeEnds) {
  drive_.closing = true;
  EXPECT_FALSE(beginTrip({2, Pose{Point(30.0, 0.0), 0.0}}, now_, drive_));
  EXPECT_EQ(drive_.goal.number, 1);
}

TEST_F(CommandLoopTest, BaseThatRollsPastTheGoalGoesBackToIt) {
  cruise();
  drive_.inputs.robot->pose.position = Point(19.9, 0.0);
  run(0.1);
  ASSERT_FALSE(drive_.hasGoal());
  drive_.inputs.robot->pose.position = Point(20.8, 0.0);
  run(1.5);
  EXPECT_FALSE(finished_);
  EXPECT_TRUE(drive_.hasGoal()) << "the trip goes on";
  EXPECT_TRUE(drive_.prepared);
  drive_.inputs.robot->pose.position = Point(20.2, 0.0);
  run(1.0);
  ASSERT_TRUE(finished_);
  EXPECT_EQ(finished_->outcome, Outcome::kReached);
}

TEST_F(CommandLoopTest, BaseThatNeverRestsAtTheGoalFails) {
  for (int i = 0; i < 10 && !finished_; ++i) {
    drive_.inputs.robot->pose.position = Point(19.9, 0.0);
    drive_.inputs.robot->velocity = Point(0.5, 0.0);
    run(0.1);
    drive_.inputs.robot->pose.position = Point(20.8, 0.0);
    run(1.0);
  }
  expectEnd(Outcome::kFailed, "failed: the base rests 0.80 m from the goal");
}

TEST_F(CommandLoopTest, BaseThatRollsOnAtTheGoalFails) {
  drive_.inputs.robot->pose.position = Point(19.9, 0.0);
  for (int i = 0; i < 200 && !finished_; ++i) {
    run(0.05);
    drive_.inputs.robot->velocity = Point(0.3, 0.0);
    drive_.inputs.robot->pose.position += Point(0.015, 0.0);
  }
  EXPECT_GT(drive_.inputs.robot->pose.position.x(), 21.0);
  expectEnd(Outcome::kFailed, "failed: the base does not rest at the goal");
}

TEST_F(CommandLoopTest, GoalIsNotReachedWhereNoOdometrySaysThatTheBaseRests) {
  drive_.inputs.robot->pose.position = Point(19.9, 0.0);
  run(0.05);
  drive_.inputs.robot->velocity = Point(0.5, 0.0);
  for (int i = 0; i < 160 && !finished_; ++i) {
    now_ += 0.05;
    finished_ = loop_.tick(now_, drive_).finished;
  }
  expectEnd(Outcome::kFailed,
            "failed: the base does not rest at the goal: odometry is silent or too old");
}

class Stalled : public CommandLoopTest {
 protected:
  Stalled() {
    drive_.progress = ProgressWatch({0.5, 5.0, 12.0});
    drive_.progress.begin(now_);
    drive_.progress.see(20.0, now_);
    StepMotion rest;
    rest.duration = 60.0;
    drive_.executor.follow(rest, now_);
  }
};

TEST_F(Stalled, IsBlockedAfterAWhileAndGivenUpAfterLonger) {
  run(4.0);
  EXPECT_EQ(toStatus(drive_, loop_.limits(), now_).state, PlannerStatus::DRIVING);
  run(2.0);
  drive_.blocker = {17, now_ - 3.0};
  const PlannerStatus status = toStatus(drive_, loop_.limits(), now_);
  EXPECT_EQ(status.state, PlannerStatus::BLOCKED);
  EXPECT_EQ(status.state_name, "BLOCKED");
  EXPECT_EQ(status.stop_cause, "no progress for 6 s: person 17 is in the way");
  EXPECT_FALSE(finished_);
  run(8.0);
  expectEnd(Outcome::kFailed, "blocked: no progress for 12 s: person 17 is in the way");
}

// A robot that drives to and fro before somebody does not stand, but gets nowhere for that person.
TEST_F(Stalled, NamesThePersonWhoWasInTheWayLately) {
  drive_.encounter = {17, now_ + 4.0};
  run(8.0);
  EXPECT_EQ(toStatus(drive_, loop_.limits(), now_).stop_cause,
            "no progress for 8 s: person 17 is in the way");
  run(3.0);
  EXPECT_EQ(toStatus(drive_, loop_.limits(), now_).stop_cause,
            "no progress for 11 s: no way on is found");
}

TEST_F(Stalled, WaitingForAPersonIsNamedWithItsTime) {
  drive_.blocker = {17, now_};
  run(2.0);
  const PlannerStatus status = toStatus(drive_, loop_.limits(), now_);
  EXPECT_EQ(status.state, PlannerStatus::WAITING_FOR_PEOPLE);
  EXPECT_EQ(status.stop_cause, "person 17 is in the way since 2.0 s");
}

TEST_F(Stalled, PauseIsNoWantOfProgress) {
  drive_.paused = true;
  run(30.0);
  EXPECT_FALSE(finished_);
  EXPECT_EQ(toStatus(drive_, loop_.limits(), now_).state, PlannerStatus::PAUSED);
}

TEST_F(CommandLoopTest, CancelWithoutOdometryIsReportedButZerosGoOn) {
  cruise();
  is_silent_ = true;
  endTrip(Outcome::kCancelled, "cancelled", now_, drive_);
  drive_.inputs.robot->velocity = Point(0.5, 0.0);
  CommandLoop::Tick last;
  for (int i = 0; i < 160; ++i) {
    now_ += 0.05;
    last = loop_.tick(now_, drive_);
    if (last.finished) finished_ = last.finished;
  }
  EXPECT_TRUE(finished_);
  ASSERT_TRUE(last.command);
  EXPECT_EQ(last.command->velocity.norm(), 0.0);
}

TEST(PoseJump, IsAWayThatNoBaseGoes) {
  RobotReading from, to;
  to.measured_at = from.measured_at + 0.5;
  to.pose.position = Point(1.9, 0.0);
  EXPECT_FALSE(isPoseJump(from, to, 2.0));
  to.pose.position = Point(2.1, 0.0);
  EXPECT_TRUE(isPoseJump(from, to, 2.0));
}

TEST(StateNames, EveryCauseHasOne) {
  for (int cause = 1; cause <= static_cast<int>(StopCause::kPaused); ++cause) {
    EXPECT_STRNE(describe(static_cast<StopCause>(cause)), "");
  }
}

}  // namespace
}  // namespace pomdp_crowd_nav
