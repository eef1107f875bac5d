// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/ros/panel/planner_watch.h"

#include <gtest/gtest.h>

namespace pomdp_crowd_nav {
namespace {

PlannerStatus drivingAt(double stamp) {
  PlannerStatus status;
  status.header.stamp = ros::Time(stamp);
  status.state = PlannerStatus::DRIVING;
  status.state_name = "DRIVING";
  return status;
}

TEST(PlannerWatch, SaysThatThereIsNoPlanner) {
  const PlannerWatch watch;
  EXPECT_FALSE(watch.isHeard(100.0));
  EXPECT_EQ(watch.texts("planner_node", {}, 100.0).state, "no planner_node");
  EXPECT_EQ(watch.texts("planner_node", {}, 100.0).mood, Mood::kUnknown);
}

TEST(PlannerWatch, SaysForHowLongItHasBeenSilent) {
  PlannerWatch watch;
  watch.setPublishers(1);
  EXPECT_TRUE(watch.hear(drivingAt(5.0), 100.0));
  EXPECT_EQ(watch.texts("planner_node", {}, 101.9).state, "DRIVING");
  EXPECT_TRUE(watch.isHeard(101.9));
  EXPECT_EQ(watch.texts("planner_node", {}, 107.0).state, "silent for 7 s");
  EXPECT_FALSE(watch.isHeard(107.0));
  watch.setPublishers(0);
  EXPECT_EQ(watch.texts("planner_node", {}, 107.0).state, "no planner_node");
  EXPECT_EQ(watch.texts("planner_node", {}, 107.0).cause, "last heard 7 s ago: DRIVING");
}

TEST(PlannerWatch, ALatchedStatusThatComesAgainIsNoNews) {
  PlannerWatch watch;
  EXPECT_TRUE(watch.hear(drivingAt(5.0), 100.0));
  EXPECT_FALSE(watch.hear(drivingAt(5.0), 110.0));
  EXPECT_FALSE(watch.isHeard(110.0));
  EXPECT_TRUE(watch.hear(drivingAt(5.5), 111.0));
  EXPECT_TRUE(watch.isHeard(111.0));
}

TEST(PlannerWatch, AClockThatStandsStillIsNoSilence) {
  PlannerWatch watch;
  PlannerStatus status = drivingAt(5.0);
  EXPECT_TRUE(watch.hear(status, 100.0));
  status.clock_age = 10.0;
  EXPECT_TRUE(watch.hear(status, 110.0));
}

TEST(StatusTexts, TellWhatTheStatusTells) {
  PlannerStatus status = drivingAt(5.0);
  status.state = PlannerStatus::WAITING_FOR_PEOPLE;
  status.state_name = "WAITING_FOR_PEOPLE";
  status.stop_cause = "person 12 is in the way since 3.0 s";
  status.cycle_time = 0.351;
  status.trials = 1234;
  status.tree_size = 5678;
  status.decisions = 40;
  status.deadline_misses = 2;
  status.odom_age = 0.021;
  status.people_age = 0.09;
  status.people = 400;
  status.map_age = 71.3;
  const StatusTexts texts = textsOf(status, 0.4);
  EXPECT_EQ(texts.mood, Mood::kWaiting);
  EXPECT_EQ(texts.state, "WAITING_FOR_PEOPLE");
  EXPECT_EQ(texts.cause, "person 12 is in the way since 3.0 s");
  EXPECT_EQ(texts.decision, "0.351 of 0.40 s, 1234 trials, 5678 nodes");
  EXPECT_EQ(texts.late, "2 of 40 decisions");
  EXPECT_EQ(texts.odometry, "0.02 s old");
  EXPECT_EQ(texts.people, "0.09 s old, 400 tracked");
  EXPECT_EQ(texts.map, "71 s old");
}

TEST(StatusTexts, OfInputsThatHaveNotComeSayIt) {
  PlannerStatus status = drivingAt(5.0);
  status.odom_age = status.people_age = status.map_age = -1.0;
  const StatusTexts texts = textsOf(status, {});
  EXPECT_EQ(texts.decision, "none yet");
  EXPECT_EQ(texts.late, "");
  EXPECT_EQ(texts.odometry, "none yet");
  EXPECT_EQ(texts.people, "none yet");
  EXPECT_EQ(texts.map, "none yet");
}

TEST(StatusTexts, EveryStateHasAMood) {
  PlannerStatus status;
  for (std::uint8_t state = PlannerStatus::IDLE; state <= PlannerStatus::BLOCKED; ++state) {
    status.state = state;
    EXPECT_NE(textsOf(status, {}).mood, Mood::kUnknown) << int(state);
  }
}

}  // namespace
}  // namespace pomdp_crowd_nav
