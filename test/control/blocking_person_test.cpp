// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/control/blocking_person.h"

#include <gtest/gtest.h>

namespace pomdp_crowd_nav {
namespace {

const BlockingPerson kBlocking({1.5, 1.7, 3.0});
const Point kRobot(10.0, 10.0);

Track person(std::int64_t id, const Point& position, const Point& velocity = Point(0.0, 0.0)) {
  return {id, position, velocity};
}

TEST(BlockingPerson, NobodyBlocksWhereNobodyIs) { EXPECT_FALSE(kBlocking.find(kRobot, 0.0, {})); }

TEST(BlockingPerson, IsTheNearestWithinTheDecisionDistance) {
  TrackList tracks;
  tracks.tracks = {person(1, {12.0, 10.0}), person(2, {10.0, 8.6}), person(3, {10.0, 11.3})};
  EXPECT_EQ(kBlocking.find(kRobot, 0.0, tracks), 3);
  EXPECT_EQ(kBlocking.find(kRobot, std::nullopt, tracks), 3);
}

TEST(BlockingPerson, ElseTheNearestInTheWayAndNotTheNearestAnywhere) {
  TrackList tracks;
  tracks.tracks = {person(1, {8.0, 10.0}), person(2, {14.0, 10.5}), person(3, {12.5, 9.0})};
  EXPECT_EQ(kBlocking.find(kRobot, 0.0, tracks), 3) << "person 1 is behind the robot";
  EXPECT_EQ(kBlocking.find(kRobot, M_PI, tracks), 1);
  EXPECT_FALSE(kBlocking.find(kRobot, M_PI_2, tracks));
  EXPECT_FALSE(kBlocking.find(kRobot, std::nullopt, tracks)) << "no way is known";
}

TEST(BlockingPerson, MayBeAboutToCross) {
  TrackList tracks;
  tracks.tracks = {person(1, {12.0, 13.5}, {0.0, -1.2}), person(2, {12.0, 12.5}, {0.0, 1.2})};
  EXPECT_EQ(kBlocking.find(kRobot, 0.0, tracks), 1) << "person 2 walks away";
}

}  // namespace
}  // namespace pomdp_crowd_nav
