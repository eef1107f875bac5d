// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/evaluation/destination_learning.h"

#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <ctime>
#include <random>

#include "../recordings.h"
#include "pomdp_crowd_nav/sim/world_file.h"

namespace pomdp_crowd_nav {
namespace {

// A straight walk of `length` seconds, a sample a second.
void addWalk(std::int64_t id, double start, double length, const Point& from, const Point& to,
             std::vector<TrackSample>& recording) {
  for (double t = 0.0; t <= length; t += 1.0) {
    recording.push_back({start + t, id, from + t / length * (to - from)});
  }
}

std::vector<TrackSample> inOrder(std::vector<TrackSample> recording) {
  std::stable_sort(recording.begin(), recording.end(),
                   [](const TrackSample& a, const TrackSample& b) { return a.time < b.time; });
  return recording;
}

TEST(DestinationLearning, FindsWhereWalksBeginAndEnd) {
  // Twelve from the left door to the right one, six of them from a lower door; 0.2 m of scatter.
  std::vector<TrackSample> recording;
  std::mt19937 random(1);
  std::uniform_real_distribution<double> off(-0.2, 0.2);
  for (int i = 0; i < 12; ++i) {
    const Point from =
        (i % 2 == 0 ? Point(0.0, 0.0) : Point(10.0, -8.0)) + Point(off(random), off(random));
    addWalk(i, 5.0 + i, 10.0, from, Point(20.0, 0.0) + Point(off(random), off(random)), recording);
  }
  addWalk(99, 0.0, 60.0, {5.0, 5.0}, {5.5, 5.0}, recording);  // who hardly moves
  const LearnedDestinations learned = learnDestinations(inOrder(recording), {});
  EXPECT_EQ(learned.walks, 12);
  EXPECT_EQ(learned.ends, 24);
  EXPECT_EQ(learned.ends_near, 24);
  ASSERT_EQ(learned.destinations.size(), 3U);
  EXPECT_EQ(learned.destinations[0].people, 12);
  EXPECT_LT((learned.destinations[0].position - Point(20.0, 0.0)).norm(), 0.2);
  EXPECT_EQ(learned.destinations[1].people, 6);
  EXPECT_EQ(learned.destinations[2].people, 6);

  LearningParams many;
  many.min_people = 7;
  EXPECT_EQ(learnDestinations(inOrder(recording), many).destinations.size(), 1U);
  LearningParams wide;
  wide.merge_distance = 14.0;
  EXPECT_LT(learnDestinations(inOrder(recording), wide).destinations.size(), 3U);
}

TEST(DestinationLearning, IsTheMeanOfWhatBelongsTogether) {
  std::vector<TrackSample> recording;
  addWalk(1, 5.0, 5.0, {0.0, 0.0}, {10.0, 0.0}, recording);
  addWalk(2, 5.0, 5.0, {0.0, 1.0}, {10.0, 0.0}, recording);
  addWalk(3, 0.0, 20.0, {50.0, 0.0}, {50.0, 0.1}, recording);
  LearningParams params;
  params.min_people = 2;
  const LearnedDestinations learned = learnDestinations(inOrder(recording), params);
  ASSERT_EQ(learned.destinations.size(), 2U);
  std::vector<Point> found{learned.destinations[0].position, learned.destinations[1].position};
  if (found[0].x() > found[1].x()) std::swap(found[0], found[1]);
  EXPECT_LT((found[0] - Point(0.0, 0.5)).norm(), 1e-9);
  EXPECT_LT((found[1] - Point(10.0, 0.0)).norm(), 1e-9);
}

TEST(DestinationLearning, WhatTheRecordingCutsOffIsNoEnd) {
  std::vector<TrackSample> recording;
  for (int i = 0; i < 6; ++i) addWalk(i, 0.0, 10.0, {0.0, 0.0}, {10.0, 0.0}, recording);
  for (int i = 6; i < 12; ++i) addWalk(i, 5.0, 10.0, {0.0, 0.0}, {10.0, 0.0}, recording);
  // The first six are there when it begins; the second six when it ends.
  const LearnedDestinations learned = learnDestinations(inOrder(recording), {});
  EXPECT_EQ(learned.walks, 12);
  EXPECT_EQ(learned.ends, 12);
  ASSERT_EQ(learned.destinations.size(), 2U);
  EXPECT_EQ(learned.destinations[0].people, 6);
}

TEST(DestinationLearning, OnePersonCountsOnce) {
  std::vector<TrackSample> recording;
  addWalk(1, 5.0, 10.0, {0.0, 0.0}, {3.5, 0.0}, recording);
  addWalk(2, 0.0, 30.0, {50.0, 0.0}, {50.0, 0.1}, recording);
  LearningParams params;
  params.merge_distance = 5.0;
  params.min_people = 1;
  const LearnedDestinations learned = learnDestinations(inOrder(recording), params);
  ASSERT_EQ(learned.destinations.size(), 1U);
  EXPECT_EQ(learned.destinations[0].people, 1);
}

TEST(DestinationLearning, YamlIsWhatNodesAndWorldsRead) {
  LearnedDestinations learned;
  learned.destinations = {{{1.5, -2.25}, 12}, {{0.0, 3.0}, 7}};
  const YAML::Node node = YAML::Load(toYaml(learned));
  const auto rows = node["destinations"].as<std::vector<std::vector<double>>>();
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0], (std::vector<double>{1.5, -2.25}));
  EXPECT_EQ(rows[1], (std::vector<double>{0.0, 3.0}));
  EXPECT_NE(toYaml(learned).find("# 12"), std::string::npos);
  EXPECT_TRUE(learnDestinations({}, {}).destinations.empty());
}

TEST(DestinationLearning, ManyWalksAllOverTheFieldTakeNoMinute) {
  std::vector<TrackSample> recording;
  std::mt19937 random(1);
  std::uniform_real_distribution<double> place(0.0, 100.0);
  for (int i = 0; i < 5000; ++i) {
    addWalk(i, 0.1 * i, 1.0, {place(random), place(random)}, {place(random), place(random)},
            recording);
  }
  const std::clock_t start = std::clock();  // of the processor
  learnDestinations(inOrder(recording), {});
  const double time = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  EXPECT_LT(time, 30.0);
}

TEST(DestinationLearning, NamesAWrongParameter) {
  const auto expectThrow = [](const LearningParams& params) {
    EXPECT_THROW(learnDestinations({}, params), std::invalid_argument);
  };
  LearningParams params;
  params.merge_distance = 0.0;
  expectThrow(params);
  params = {};
  params.min_people = 0;
  expectThrow(params);
}

// What somebody has put down by hand for these recordings, found again; the tool may find more.
TEST(DestinationLearning, FindsTheDestinationsOfRecordedPeople) {
  for (const std::string name : {"ucy_students03", "ucy_zara01"}) {
    const std::string tracks = recordingPath(name + ".csv");
    if (!isThere(tracks)) GTEST_SKIP() << tracks << " is absent; set UCY_DATA_DIR to its folder";
    const World world = loadWorld(SOURCE_DIR "/config/worlds/" + name + ".yaml");
    const LearnedDestinations learned = learnDestinations(readTracksFile(tracks), {});
    printf("%s: %d walks, %d of %d ends near\n%s", name.c_str(), learned.walks, learned.ends_near,
           learned.ends, toYaml(learned).c_str());
    EXPECT_LE(learned.destinations.size(), world.destinations.size() + 1);
    EXPECT_GT(learned.ends_near, 0.7 * learned.ends);
    for (const Point& known : world.destinations) {
      double nearest = 100.0;
      for (const LearnedDestination& found : learned.destinations) {
        nearest = std::min(nearest, (found.position - known).norm());
      }
      EXPECT_LT(nearest, 1.5) << name << ": " << known.transpose();
    }
  }
}

}  // namespace
}  // namespace pomdp_crowd_nav
