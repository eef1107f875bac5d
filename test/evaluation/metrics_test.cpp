// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/evaluation/metrics.h"

#include <gtest/gtest.h>

namespace pomdp_crowd_nav {
namespace {

std::vector<Walker> at(const Point& position) { return {{1, position}}; }
const std::vector<Walker> kNobody;

TEST(MetricsRecorder, AddsUpTimeAndWay) {
  MetricsRecorder recorder({});
  recorder.tick(0.1, {0.0, 0.0}, 1.0, kNobody);
  recorder.tick(0.2, {3.0, 4.0}, 2.0, kNobody);
  recorder.tick(0.3, {3.0, 3.0}, 1.5, kNobody);
  EXPECT_DOUBLE_EQ(recorder.metrics().travel_time, 0.3);
  EXPECT_DOUBLE_EQ(recorder.metrics().path_length, 6.0);
  EXPECT_DOUBLE_EQ(recorder.metrics().max_speed, 2.0);
  EXPECT_EQ(recorder.metrics().min_moving_distance, std::numeric_limits<double>::infinity());
}

TEST(MetricsRecorder, DistancesCountWhileTheRobotMoves) {
  MetricsRecorder recorder({});
  recorder.tick(0.1, {0.0, 0.0}, 0.0, at({0.2, 0.0}));
  EXPECT_EQ(recorder.metrics().unsafe_steps, 0) << "somebody walked up to a standing robot";
  EXPECT_EQ(recorder.metrics().min_moving_distance, std::numeric_limits<double>::infinity());
  recorder.tick(0.2, {0.0, 0.0}, 0.05, at({0.7, 0.0}));
  EXPECT_DOUBLE_EQ(recorder.metrics().min_moving_distance, 0.7);
  EXPECT_EQ(recorder.metrics().unsafe_steps, 1);
  EXPECT_EQ(recorder.metrics().unsafe_ticks, 0);
  recorder.tick(0.3, {0.0, 0.0}, 1.0, {{1, {9.0, 0.0}}, {2, {0.0, 0.5}}, {3, {5.0, 0.0}}});
  EXPECT_DOUBLE_EQ(recorder.metrics().min_moving_distance, 0.5);
  EXPECT_EQ(recorder.metrics().unsafe_ticks, 1) << "0.5 m is within 0.5 m";
  EXPECT_EQ(recorder.metrics().contact_ticks, 1);
}

TEST(MetricsRecorder, LooksBetweenTicksCountStepsAndDistanceAlone) {
  MetricsRecorder recorder({});
  recorder.look(0.02, {0.0, 0.0}, 1.0, at({0.4, 0.0}));
  recorder.look(0.04, {0.0, 0.0}, 0.0, at({0.1, 0.0}));
  EXPECT_DOUBLE_EQ(recorder.metrics().min_moving_distance, 0.4);
  EXPECT_EQ(recorder.metrics().unsafe_steps, 1);
  EXPECT_EQ(recorder.metrics().unsafe_ticks, 0);
  EXPECT_EQ(recorder.metrics().travel_time, 0.0);
}

TEST(MetricsRecorder, ArrivalStopsTheTravelTimeAlone) {
  MetricsRecorder recorder({});
  recorder.tick(0.1, {0.0, 0.0}, 1.0, kNobody);
  recorder.arrive();
  recorder.tick(0.2, {1.0, 0.0}, 1.0, at({1.4, 0.0}));
  EXPECT_DOUBLE_EQ(recorder.metrics().travel_time, 0.1);
  EXPECT_DOUBLE_EQ(recorder.metrics().min_moving_distance, 0.4);
  EXPECT_EQ(recorder.metrics().unsafe_steps, 1);
}

TEST(MetricsRecorder, OneMetreIsSafe) {
  MetricsRecorder recorder({});
  recorder.tick(0.1, {0.0, 0.0}, 1.0, at({1.0, 0.0}));
  EXPECT_EQ(recorder.metrics().unsafe_steps, 0);
  recorder.tick(0.2, {0.0, 0.0}, 1.0, at({0.999, 0.0}));
  EXPECT_EQ(recorder.metrics().unsafe_steps, 1);
}

// Ten ticks are one step; the tick that ends with a step is part of it.
TEST(MetricsRecorder, AStepIsUnsafeOnce) {
  MetricsRecorder recorder({});
  for (int i = 1; i <= 10; ++i) recorder.tick(0.1 * i, {0.0, 0.0}, 1.0, at({0.8, 0.0}));
  EXPECT_EQ(recorder.metrics().unsafe_steps, 1);
  recorder.tick(1.1, {0.0, 0.0}, 1.0, at({0.8, 0.0}));
  EXPECT_EQ(recorder.metrics().unsafe_steps, 2);
  recorder.tick(2.5, {0.0, 0.0}, 1.0, at({0.8, 0.0}));
  EXPECT_EQ(recorder.metrics().unsafe_steps, 3);
}

TEST(MetricsRecorder, CountsDecisions) {
  MetricsRecorder recorder({});
  recorder.countDecision(false, false);
  recorder.countDecision(true, false);
  recorder.countDecision(true, true);
  EXPECT_EQ(recorder.metrics().decisions, 3);
  EXPECT_EQ(recorder.metrics().sudden_brakes, 2);
  EXPECT_EQ(recorder.metrics().deadline_misses, 1);
}

TEST(MetricsRecorder, ResetKeepsTheParametersOnly) {
  MetricsRecorder::Params params;
  params.unsafe_distance = 3.0;
  MetricsRecorder recorder(params);
  recorder.tick(0.1, {0.0, 0.0}, 1.0, at({2.0, 0.0}));
  recorder.countDecision(true, true);
  recorder.reset();
  EXPECT_EQ(recorder.metrics().decisions, 0);
  EXPECT_EQ(recorder.metrics().unsafe_steps, 0);
  EXPECT_EQ(recorder.metrics().path_length, 0.0);
  recorder.tick(0.1, {50.0, 0.0}, 1.0, at({52.0, 0.0}));
  EXPECT_EQ(recorder.metrics().unsafe_steps, 1);
  EXPECT_EQ(recorder.metrics().path_length, 0.0) << "no way from the trip before";
}

}  // namespace
}  // namespace pomdp_crowd_nav
