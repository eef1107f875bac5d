// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/ros/track_filter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace pomdp_crowd_nav {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

Track at(std::int64_t id, double x, double y = 0.0) { return {id, Point(x, y), Point(0.0, 0.0)}; }

TEST(TrackFilter, LeavesWhatIsFineAlone) {
  TrackList list{1.0, {at(3, 1.0), at(7, 2.0)}};
  const LeftOut left_out = filterTracks({}, Point(0.0, 0.0), list);
  EXPECT_EQ(list.tracks.size(), 2u);
  EXPECT_EQ(left_out.bad + left_out.duplicates + left_out.surplus, 0u);
}

TEST(TrackFilter, PositionsThatAreNoneAreLeftOutAndCounted) {
  TrackList list{1.0, {at(1, kNaN), at(2, 2.0e6), at(3, 0.0, -1.0e300), at(4, 4.0)}};
  EXPECT_EQ(filterTracks({}, std::nullopt, list).bad, 3u);
  ASSERT_EQ(list.tracks.size(), 1u);
  EXPECT_EQ(list.tracks[0].id, 4);
}

TEST(TrackFilter, ASpeedThatNobodyHasIsNotKnown) {
  TrackList list{1.0, {at(1, 1.0), at(2, 2.0)}};
  list.tracks[0].velocity = Point(0.0, 500.0);
  list.tracks[1].velocity = Point(3.0, 0.0);
  filterTracks({}, std::nullopt, list);
  EXPECT_EQ(list.tracks[0].velocity, Point(0.0, 0.0));
  EXPECT_EQ(list.tracks[1].velocity, Point(3.0, 0.0));
}

TEST(TrackFilter, OfTwoWithOneIdTheLastStays) {
  TrackList list{1.0, {at(5, 1.0), at(2, 2.0), at(5, 3.0), at(5, 4.0)}};
  EXPECT_EQ(filterTracks({}, std::nullopt, list).duplicates, 2u);
  ASSERT_EQ(list.tracks.size(), 2u);
  EXPECT_EQ(list.tracks[0].id, 2);
  EXPECT_EQ(list.tracks[1].position.x(), 4.0);
}

TEST(TrackFilter, OfTenThousandTheNearestStay) {
  TrackList list;
  for (int i = 0; i < 10000; ++i) list.tracks.push_back(at((i * 7919) % 10000, i));
  const LeftOut left_out = filterTracks({}, Point(5000.0, 0.0), list);
  EXPECT_EQ(left_out.surplus, 9000u);
  ASSERT_EQ(list.tracks.size(), 1000u);
  for (const Track& track : list.tracks) EXPECT_LE(std::abs(track.position.x() - 5000.0), 500.0);
  EXPECT_TRUE(std::is_sorted(list.tracks.begin(), list.tracks.end(),
                             [](const Track& a, const Track& b) { return a.id < b.id; }));
}

TEST(TrackFilter, TheFirstOnesStayWhileTheRobotsPlaceIsNotKnown) {
  TrackList list{1.0, {at(1, 9.0), at(2, 8.0), at(3, 7.0)}};
  TrackRange range;
  range.max_people = 2;
  EXPECT_EQ(filterTracks(range, std::nullopt, list).surplus, 1u);
  EXPECT_EQ(list.tracks[1].id, 2);
}

}  // namespace
}  // namespace pomdp_crowd_nav
