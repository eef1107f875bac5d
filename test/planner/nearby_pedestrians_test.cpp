// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/planner/nearby_pedestrians.h"

#include <gtest/gtest.h>

namespace pomdp_crowd_nav {
namespace {

PersonBelief person(std::int64_t id, const Point& position, const Point& velocity = {0.0, 0.0}) {
  return {id, position, velocity, 1.0, IntentionBelief(2)};
}

std::vector<std::int64_t> idsOf(const std::vector<PersonBelief>& people) {
  std::vector<std::int64_t> ids;
  for (const PersonBelief& one : people) ids.push_back(one.id);
  return ids;
}

using Ids = std::vector<std::int64_t>;

AttentionParams attention(int pedestrians, double half_angle = M_PI, double lookahead = 0.0) {
  AttentionParams params;
  params.pedestrians = pedestrians;
  params.half_angle = half_angle;
  params.lookahead = lookahead;
  return params;
}

const VehicleState kEastbound{{10.0, 10.0}, 0.0, 2.0};

TEST(NearbyPedestrians, TakesTheNearestByIncreasingId) {
  const CrowdBelief crowd{
      0.0,
      {person(1, {30.0, 10.0}), person(2, {13.0, 10.0}), person(3, {10.0, 15.0}),
       person(4, {9.0, 10.0}), person(5, {10.0, 6.0})}};
  EXPECT_EQ(idsOf(nearbyPedestrians(crowd, kEastbound, attention(3))), (Ids{2, 4, 5}));
  EXPECT_EQ(idsOf(nearbyPedestrians(crowd, kEastbound, attention(1))), (Ids{4}));
  EXPECT_EQ(idsOf(nearbyPedestrians(crowd, kEastbound, attention(9))), (Ids{1, 2, 3, 4, 5}));
  EXPECT_TRUE(nearbyPedestrians(crowd, kEastbound, attention(0)).empty());
  EXPECT_TRUE(nearbyPedestrians({}, kEastbound, attention(6)).empty());
}

TEST(NearbyPedestrians, OfTwoAtOneDistanceTheLowerIdCounts) {
  const CrowdBelief crowd{
      0.0, {person(3, {13.0, 10.0}), person(4, {7.0, 10.0}), person(5, {10.0, 13.0})}};
  EXPECT_EQ(idsOf(nearbyPedestrians(crowd, kEastbound, attention(2))), (Ids{3, 4}));
}

TEST(NearbyPedestrians, LooksIntoTheConeAroundTheDirectionOfTravel) {
  const double half_angle = M_PI / 4.0;
  const CrowdBelief crowd{0.0,
                          {person(1, {15.0, 14.9}),   // 44 deg to the left
                           person(2, {15.0, 15.1}),   // 46 deg
                           person(3, {15.0, 5.1}),    // 44 deg to the right
                           person(4, {5.0, 10.0})}};  // behind
  EXPECT_EQ(idsOf(nearbyPedestrians(crowd, kEastbound, attention(6, half_angle))), (Ids{1, 3}));
  VehicleState westbound = kEastbound;
  westbound.heading = M_PI - 0.01;
  EXPECT_EQ(idsOf(nearbyPedestrians(crowd, westbound, attention(6, half_angle))), (Ids{4}));
  westbound.heading = -M_PI + 0.01;
  EXPECT_EQ(idsOf(nearbyPedestrians(crowd, westbound, attention(6, half_angle))), (Ids{4}));
}

TEST(NearbyPedestrians, WhoIsCloseCountsInTheConeOrNot) {
  const CrowdBelief crowd{0.0, {person(1, {9.05, 10.0}), person(2, {8.95, 10.0})}};
  EXPECT_EQ(idsOf(nearbyPedestrians(crowd, kEastbound, attention(6, 0.5))), (Ids{1}));
  const CrowdBelief here{0.0, {person(1, {10.0, 10.0})}};
  EXPECT_EQ(idsOf(nearbyPedestrians(here, kEastbound, attention(6, 0.5))), (Ids{1}));
}

// In one second the robot is at (12, 10).
TEST(NearbyPedestrians, WhoWillBeNearIsAsNearAsWhoIsNearNow) {
  const CrowdBelief crowd{0.0,
                          {person(1, {8.5, 10.0}),                // 1.5 m now, 3.5 m then
                           person(2, {14.0, 10.0}, {-1.0, 0.0}),  // 4 m now, 1 m then
                           person(3, {12.0, 12.0})}};             // 2.8 m now, 2 m then
  EXPECT_EQ(idsOf(nearbyPedestrians(crowd, kEastbound, attention(2, M_PI, 0.0))), (Ids{1, 3}));
  EXPECT_EQ(idsOf(nearbyPedestrians(crowd, kEastbound, attention(2, M_PI, 1.0))), (Ids{1, 2}));
  EXPECT_EQ(idsOf(nearbyPedestrians(crowd, kEastbound, attention(1, M_PI, 1.0))), (Ids{2}));
}

TEST(NearbyPedestrians, ReturnsWholeBeliefs) {
  PersonBelief sure = person(8, {12.0, 10.0}, {0.3, 0.4});
  sure.intention.update({0.0, 0.0}, {1.0, 0.0}, {{9.0, 0.0}, {-9.0, 0.0}});
  const auto nearby = nearbyPedestrians({0.0, {sure}}, kEastbound, attention(6));
  ASSERT_EQ(nearby.size(), 1U);
  EXPECT_EQ(nearby[0].velocity, Point(0.3, 0.4));
  EXPECT_EQ(nearby[0].intention.probabilities(), sure.intention.probabilities());
}

}  // namespace
}  // namespace pomdp_crowd_nav
