// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/ros/robot_markers.h"

#include <gtest/gtest.h>

#include <cmath>

#include "marker_checks.h"

namespace pomdp_crowd_nav {
namespace {

using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

PlannerStatus statusOf(std::uint8_t state, const std::string& name, const std::string& cause) {
  PlannerStatus status;
  status.state = state;
  status.state_name = name;
  status.stop_cause = cause;
  return status;
}

MarkerArray draw(const PlannerStatus& status, double emergency_distance, const Trail& trail) {
  std_msgs::Header header;
  header.frame_id = "map";
  header.stamp = ros::Time(5.0);
  return robotMarkers({trail, status, "base_link", Point(3.0, 4.0), Point(50.0, 104.0), 0.5,
                       emergency_distance, 1.0},
                      header);
}

Trail drivenTrail() {
  Trail trail({2000, 0.25, 3.0});
  for (int i = 0; i < 100; ++i) trail.extend(Point(0.5 * i, 0.0));
  return trail;
}

TEST(RobotMarkers, DiscAndEmergencyDistanceMoveWithTheBase) {
  const PlannerStatus driving = statusOf(PlannerStatus::DRIVING, "DRIVING", "");
  const MarkerArray array = draw(driving, 2.0, drivenTrail());
  expectSound(array);
  for (const char* name : {"disc", "emergency_distance"}) {
    const Marker list = listOf(array, name);
    EXPECT_EQ(list.header.frame_id, "base_link");
    EXPECT_TRUE(list.header.stamp.isZero()) << "RViz takes the newest transform then";
    EXPECT_TRUE(list.frame_locked);
  }
  for (const auto& point : listOf(array, "emergency_distance").points) {
    EXPECT_NEAR(std::hypot(point.x, point.y), 2.0, 1e-6);
  }
  EXPECT_EQ(listOf(array, "driven").header.frame_id, "map");
}

TEST(RobotMarkers, ThereIsNoEmergencyDistanceWhereNoneIsSet) {
  const MarkerArray array = draw(PlannerStatus(), 0.0, Trail({2}));
  expectSound(array);
  EXPECT_TRUE(listOf(array, "emergency_distance").points.empty());
  EXPECT_TRUE(listOf(array, "driven").points.empty());
}

TEST(RobotMarkers, WhereItWasLongAgoIsPaler) {
  const Marker driven = listOf(draw(PlannerStatus(), 0.0, drivenTrail()), "driven");
  ASSERT_EQ(driven.points.size(), 198u);
  EXPECT_GT(driven.colors.front().r, driven.colors.back().r);
}

TEST(RobotMarkers, TheCauseStandsBesideARobotThatDoesNotDrive) {
  const auto cause = [](const PlannerStatus& status) {
    return listOf(draw(status, 2.0, Trail({2})), "cause").text;
  };
  EXPECT_EQ(cause(statusOf(PlannerStatus::DRIVING, "DRIVING", "")), "");
  EXPECT_EQ(cause(statusOf(PlannerStatus::IDLE, "IDLE", "")), "");
  EXPECT_EQ(cause(statusOf(PlannerStatus::PAUSED, "PAUSED", "")), "PAUSED");
  EXPECT_EQ(cause(statusOf(PlannerStatus::WAITING_FOR_PEOPLE, "WAITING_FOR_PEOPLE",
                           "person 7 is in the way since 1.0 s")),
            "person 7 is in the way since 1.0 s");
}

TEST(StatusText, TellsStateCauseDecisionTimeAndTrials) {
  PlannerStatus status = statusOf(PlannerStatus::WAITING_FOR_INPUT, "WAITING_FOR_INPUT", "no map");
  EXPECT_EQ(statusText(status), "WAITING_FOR_INPUT: no map");
  status.decisions = 12;
  status.cycle_time = 0.351;
  status.trials = 4321;
  status.tree_size = 98765;
  status.action = "turn 20 deg";
  EXPECT_EQ(statusText(status),
            "WAITING_FOR_INPUT: no map\ndecision 12 in 0.35 s, 4321 trials, 98765 beliefs, "
            "turn 20 deg");
}

}  // namespace
}  // namespace pomdp_crowd_nav
