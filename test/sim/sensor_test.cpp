// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/sim/sensor.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "temporary_file.h"

namespace pomdp_crowd_nav {
namespace {

const Point kHere(0.0, 0.0);

PersonSensor::Params withNoise(double noise) {
  PersonSensor::Params params;
  params.position_noise = noise;
  return params;
}

PersonSensor::Params withDropout(double dropout) {
  PersonSensor::Params params;
  params.dropout = dropout;
  return params;
}

TEST(PersonSensor, ReportsPeopleInRange) {
  PersonSensor sensor({}, 1);
  const TrackList list = sensor.sweep(kHere, {{4, {0.0, 30.0}}, {5, {30.1, 0.0}}}, 2.5);
  EXPECT_EQ(list.stamp, 2.5);
  ASSERT_EQ(list.tracks.size(), 1u);
  EXPECT_EQ(list.tracks[0].id, 4);
  EXPECT_EQ(list.tracks[0].position, Point(0.0, 30.0));
}

TEST(PersonSensor, VelocityIsTheMeanOverTheWindow) {
  PersonSensor sensor({}, 1);
  // Standing until 0.5 s, then 2 m/s along x: the window of 0.5 s sees 0, ..., 0, 0.4, 0.8, ...
  for (int i = 0; i <= 10; ++i) {
    const double x = i <= 5 ? 0.0 : 0.2 * (i - 5);
    const TrackList list = sensor.sweep(kHere, {{1, {x, 0.0}}}, 0.1 * i);
    const double expected = i <= 5 ? 0.0 : 0.4 * (i - 5);
    EXPECT_NEAR(list.tracks.at(0).velocity.x(), expected, 1e-9) << i;
  }
}

TEST(PersonSensor, SomebodyNewHasNoVelocity) {
  PersonSensor sensor({}, 1);
  EXPECT_EQ(sensor.sweep(kHere, {{1, {5.0, 0.0}}}, 0.0).tracks.at(0).velocity, kHere);
  EXPECT_NEAR(sensor.sweep(kHere, {{1, {5.1, 0.0}}}, 0.1).tracks.at(0).velocity.x(), 1.0, 1e-9);
  sensor.sweep(kHere, {}, 0.2);  // gone
  EXPECT_EQ(sensor.sweep(kHere, {{1, {5.3, 0.0}}}, 0.3).tracks.at(0).velocity, kHere);
  sensor.reset();
  EXPECT_EQ(sensor.sweep(kHere, {{1, {5.4, 0.0}}}, 0.4).tracks.at(0).velocity, kHere);
}

TEST(PersonSensor, OldSightingsSayNothing) {
  PersonSensor sensor({}, 1);
  sensor.sweep(kHere, {{1, {29.0, 0.0}}}, 0.0);
  sensor.sweep(kHere, {{1, {31.0, 0.0}}}, 2.0);  // out of range
  EXPECT_EQ(sensor.sweep(kHere, {{1, {29.0, 3.0}}}, 4.0).tracks.at(0).velocity, kHere);
}

TEST(PersonSensor, SameStampAgainReplacesASighting) {
  PersonSensor sensor({}, 1);
  sensor.sweep(kHere, {{1, {0.0, 0.0}}}, 0.0);
  for (int i = 0; i < 4; ++i) {
    const TrackList list = sensor.sweep(kHere, {{1, {0.4, 0.0}}}, 0.4);
    EXPECT_NEAR(list.tracks.at(0).velocity.x(), 1.0, 1e-9);
  }
}

TEST(PersonSensor, NoiseHasTheGivenDeviation) {
  PersonSensor sensor(withNoise(0.2), 1);
  const int count = 20000;
  Point sum(0.0, 0.0), squares(0.0, 0.0);
  for (int i = 0; i < count; ++i) {
    const Point error =
        sensor.sweep(kHere, {{1, {3.0, 4.0}}}, i).tracks.at(0).position - Point(3.0, 4.0);
    sum += error;
    squares += error.cwiseProduct(error);
  }
  for (int axis = 0; axis < 2; ++axis) {
    EXPECT_NEAR(sum[axis] / count, 0.0, 0.006);
    EXPECT_NEAR(std::sqrt(squares[axis] / count), 0.2, 0.004);
  }
}

TEST(PersonSensor, MissesTheGivenShare) {
  PersonSensor sensor(withDropout(0.3), 1);
  int seen = 0;
  for (int i = 0; i < 10000; ++i) {
    seen += static_cast<int>(sensor.sweep(kHere, {{1, {3.0, 4.0}}}, 0.1 * i).tracks.size());
  }
  EXPECT_NEAR(seen, 7000, 200);  // standard deviation 46
  PersonSensor blind(withDropout(1.0), 1);
  EXPECT_TRUE(blind.sweep(kHere, {{1, {3.0, 4.0}}}, 0.0).tracks.empty());
}

TEST(PersonSensor, KeepsVelocityAcrossADropout) {
  PersonSensor sensor(withDropout(0.5), 4);
  int moving = 0, seen = 0;
  for (int i = 0; i < 200; ++i) {
    for (const Track& track : sensor.sweep(kHere, {{1, {0.1 * i, 0.0}}}, 0.1 * i).tracks) {
      ++seen;
      moving += std::abs(track.velocity.x() - 1.0) < 1e-6;
    }
  }
  EXPECT_GE(moving, seen - 2);
}

TEST(PersonSensor, SameSeedSameSweep) {
  PersonSensor a(withNoise(0.1), 9), b(withNoise(0.1), 9);
  const std::vector<Walker> people = {{1, {1.0, 0.0}}, {2, {2.0, 0.0}}};
  for (int i = 0; i < 10; ++i) {
    const TrackList first = a.sweep(kHere, people, i), second = b.sweep(kHere, people, i);
    EXPECT_EQ(first.tracks.at(1).position, second.tracks.at(1).position);
  }
}

TEST(PersonSensor, NamesAWrongParameter) {
  PersonSensor::Params params;
  params.range = -2.5;
  EXPECT_EQ(messageOf([&] { PersonSensor(params, 1); }), "sensor.range must be positive, got -2.5");
  EXPECT_EQ(messageOf([] { PersonSensor(withNoise(-0.5), 1); }),
            "sensor.position_noise must be finite and not negative, got -0.5");
  EXPECT_EQ(messageOf([] { PersonSensor(withDropout(1.5), 1); }),
            "sensor.dropout must be in [0, 1], got 1.5");
  params = {};
  params.velocity_window = -0.5;
  EXPECT_EQ(messageOf([&] { PersonSensor(params, 1); }),
            "sensor.velocity_window must be positive and finite, got -0.5");
}

}  // namespace
}  // namespace pomdp_crowd_nav
