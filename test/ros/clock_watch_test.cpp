// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/ros/clock_watch.h"

#include <gtest/gtest.h>

namespace pomdp_crowd_nav {
namespace {

// Both clocks run by hand.
class ClockWatchTest : public testing::Test {
 protected:
  ClockWatch::Look look(double ros_time, double steady) {
    ros_time_ = ros_time;
    steady_ = steady;
    return watch_.look();
  }

  // Held up for `pause` [s] before or after ROS time is read, which is `ros_time` then.
  ClockWatch::Look lookHeldUp(double ros_time, double steady, double pause) {
    pause_ = pause;
    return look(ros_time, steady);
  }

  double ros_time_ = 0.0;
  double steady_ = 50.0;
  double pause_ = 0.0;
  ClockWatch watch_{[this] {
                      steady_ += pause_;
                      pause_ = 0.0;
                      return ros_time_;
                    },
                    [this] { return steady_; }};
};

TEST_F(ClockWatchTest, ATickingClockNeitherJumpsNorStands) {
  for (int i = 1; i < 100; ++i) {
    const ClockWatch::Look seen = look(1000.0 + 0.05 * i, 50.0 + 0.05 * i);
    EXPECT_FALSE(seen.jumped);
    EXPECT_DOUBLE_EQ(seen.moved_at, 50.0 + 0.05 * i);
    EXPECT_DOUBLE_EQ(seen.ros_time, ros_time_);
    EXPECT_DOUBLE_EQ(seen.now, steady_);
  }
  EXPECT_EQ(watch_.epoch(), 0);
}

TEST_F(ClockWatchTest, BeforeTheFirstTimeItStandsAndTheFirstTimeIsNoJump) {
  EXPECT_DOUBLE_EQ(look(0.0, 55.0).moved_at, 50.0);
  const ClockWatch::Look seen = look(1.7e9, 56.0);
  EXPECT_FALSE(seen.jumped);
  EXPECT_DOUBLE_EQ(seen.moved_at, 56.0);
}

TEST_F(ClockWatchTest, AJumpBackIsSeenOnceAndTimeGoesOnFromThere) {
  look(1000.0, 50.0);
  EXPECT_FALSE(look(999.95, 50.1).jumped);  // set back a little
  EXPECT_TRUE(look(990.0, 50.2).jumped);
  const ClockWatch::Look seen = look(990.1, 50.3);
  EXPECT_FALSE(seen.jumped);
  EXPECT_EQ(seen.epoch, 1);
  EXPECT_DOUBLE_EQ(seen.moved_at, 50.3);
}

TEST_F(ClockWatchTest, AJumpAheadIsSeenOnce) {
  look(1000.0, 50.0);
  EXPECT_FALSE(look(1001.5, 50.1).jumped);  // a fast simulation
  EXPECT_TRUE(look(1011.6, 50.2).jumped);
  EXPECT_FALSE(look(1011.7, 50.3).jumped);
}

TEST_F(ClockWatchTest, TimeThatWentOnUnseenIsNoJump) {
  look(1000.0, 50.0);
  EXPECT_FALSE(look(1060.0, 110.0).jumped);
}

// As of a process that was stopped, or a thread that had to wait for the processor.
TEST_F(ClockWatchTest, AThreadThatIsHeldUpBetweenBothClocksSeesNoJump) {
  look(1000.0, 50.0);
  EXPECT_FALSE(lookHeldUp(1000.1, 50.1, 5.0).jumped) << "ROS time was read before the pause";
  EXPECT_FALSE(look(1005.2, 55.2).jumped);
  EXPECT_FALSE(lookHeldUp(1010.3, 55.3, 5.0).jumped) << "and after it";
  EXPECT_FALSE(look(1010.4, 60.4).jumped);
  EXPECT_EQ(watch_.epoch(), 0);
}

// Simulated time comes in messages, which a busy machine delivers late and then at once.
TEST_F(ClockWatchTest, SimulatedTimeThatCatchesUpIsNoJump) {
  look(1000.0, 50.0);
  for (int i = 1; i <= 50; ++i) EXPECT_FALSE(look(1000.0, 50.0 + 0.1 * i).jumped);
  EXPECT_FALSE(look(1005.1, 55.1).jumped);
}

TEST_F(ClockWatchTest, SaysSinceWhenItStands) {
  look(1000.0, 50.0);
  look(1000.1, 50.1);
  EXPECT_DOUBLE_EQ(look(1000.1, 58.0).moved_at, 50.1);
}

}  // namespace
}  // namespace pomdp_crowd_nav
