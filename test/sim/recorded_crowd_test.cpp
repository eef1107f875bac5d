// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/sim/recorded_crowd.h"

#include <gtest/gtest.h>

#include <map>

#include "../recordings.h"
#include "temporary_file.h"

namespace pomdp_crowd_nav {
namespace {

// Two people sampled every 0.4 s: person 1 walks along x at 1 m/s from 0 s to 1.2 s, person 2
// stands at (5, 5) from 0.4 s to 0.8 s.
const std::vector<TrackSample> kRecording = {
    {0.0, 1, {0.0, 0.0}}, {0.4, 1, {0.4, 0.0}}, {0.4, 2, {5.0, 5.0}},
    {0.8, 1, {0.8, 0.0}}, {0.8, 2, {5.0, 5.0}}, {1.2, 1, {1.2, 0.0}},
};

RecordedCrowd replay(double start_time, int ticks, std::vector<std::int64_t> left_out = {}) {
  RecordedCrowd crowd(kRecording, {start_time, std::move(left_out)});
  for (int i = 0; i < ticks; ++i) crowd.tick();
  return crowd;
}

std::vector<std::int64_t> ids(const std::vector<Walker>& walkers) {
  std::vector<std::int64_t> list;
  for (const Walker& walker : walkers) list.push_back(walker.id);
  return list;
}

using Ids = std::vector<std::int64_t>;

TEST(RecordedCrowd, TruthRunsBetweenSamplesAndSightingsDoNot) {
  const RecordedCrowd crowd = replay(0.0, 3);
  EXPECT_EQ(ids(crowd.walkers()), Ids{1});
  EXPECT_NEAR(crowd.walkers()[0].position.x(), 0.3, 1e-12);
  EXPECT_EQ(crowd.sighted().at(0).position, Point(0.0, 0.0));
  EXPECT_NEAR(crowd.sightingAge(), 0.3, 1e-12);
}

TEST(RecordedCrowd, SampleCountsFromItsOwnTimeOn) {
  const RecordedCrowd crowd = replay(0.0, 4);
  EXPECT_EQ(ids(crowd.sighted()), (Ids{1, 2}));
  EXPECT_EQ(crowd.sighted()[0].position, Point(0.4, 0.0));
  EXPECT_NEAR(crowd.sightingAge(), 0.0, 1e-9);
}

TEST(RecordedCrowd, PeopleLeaveAfterTheirLastSample) {
  EXPECT_EQ(ids(replay(0.0, 8).walkers()), (Ids{1, 2}));
  EXPECT_EQ(ids(replay(0.0, 9).walkers()), Ids{1});
  EXPECT_EQ(ids(replay(0.0, 14).sighted()), (Ids{1, 2}));  // 1.5 periods after 0.8 s
  EXPECT_EQ(ids(replay(0.0, 15).sighted()), Ids{1});
}

TEST(RecordedCrowd, NobodyIsThereAfterTheRecording) {
  const RecordedCrowd crowd = replay(0.0, 19);
  EXPECT_TRUE(crowd.walkers().empty());
  EXPECT_TRUE(crowd.sighted().empty());
  EXPECT_EQ(crowd.sightingAge(), 0.0);
  EXPECT_TRUE(replay(1000.0, 0).walkers().empty());
  EXPECT_TRUE(replay(-1000.0, 0).sighted().empty());
}

TEST(RecordedCrowd, StartsWithinTheRecording) {
  const RecordedCrowd crowd = replay(0.5, 1);
  EXPECT_NEAR(crowd.walkers().at(0).position.x(), 0.6, 1e-12);
  EXPECT_NEAR(crowd.sightingAge(), 0.2, 1e-12);
}

TEST(RecordedCrowd, LeavesOutWhomTheRobotReplaces) {
  EXPECT_EQ(ids(replay(0.4, 0, {1}).walkers()), Ids{2});
  EXPECT_EQ(messageOf([] { replay(0.0, 0, {9}); }),
            "left_out names person 9, who is not in the recording");
}

TEST(RecordedCrowd, BridgesALostSampleInTruthOnly) {
  const std::vector<TrackSample> gap = {{0.0, 1, {0.0, 0.0}},
                                        {0.4, 1, {0.4, 0.0}},
                                        {0.8, 1, {0.8, 0.0}},
                                        {2.0, 1, {2.0, 0.0}},
                                        {2.4, 1, {2.4, 0.0}}};
  RecordedCrowd crowd(gap, {});
  for (int i = 0; i < 16; ++i) crowd.tick();
  EXPECT_NEAR(crowd.walkers().at(0).position.x(), 1.6, 1e-12);
  EXPECT_TRUE(crowd.sighted().empty());
}

TEST(RecordedCrowd, NeverRevealsTheFuture) {
  const std::string path = recordingPath("ucy_zara01.csv");
  if (!isThere(path)) GTEST_SKIP() << path << " is absent; set UCY_DATA_DIR to its folder";
  const std::vector<TrackSample> recording = readTracksFile(path);
  RecordedCrowd crowd(recording, {});
  std::map<std::int64_t, TrackSample> last;  // of each person, at or before now
  size_t next = 0;
  for (int i = 0; i < 3700; ++i) {
    const double now = 0.1 * i;
    for (; next < recording.size() && recording[next].time <= now + 1e-9; ++next) {
      last[recording[next].id] = recording[next];
    }
    for (const Walker& walker : crowd.sighted()) {
      ASSERT_EQ(last.count(walker.id), 1u);
      ASSERT_EQ(walker.position, last[walker.id].position);
      ASSERT_LE(now - last[walker.id].time, 0.6 + 1e-9);
    }
    crowd.tick();
  }
  EXPECT_EQ(next, recording.size());
  EXPECT_TRUE(crowd.walkers().empty());
}

}  // namespace
}  // namespace pomdp_crowd_nav
