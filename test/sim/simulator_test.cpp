// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/sim/simulator.h"

#include <gtest/gtest.h>

#include "temporary_file.h"

namespace pomdp_crowd_nav {
namespace {

World openField() { return loadWorld(SOURCE_DIR "/config/worlds/scenario_1.yaml"); }

Simulator::Params withPedestrians(int pedestrians) {
  Simulator::Params params;
  params.pedestrians = pedestrians;
  return params;
}

TEST(Simulator, StartsAtRestAtTheStart) {
  const Simulator simulator(openField(), withPedestrians(0));
  EXPECT_EQ(simulator.time(), 0.0);
  EXPECT_EQ(simulator.base().pose().position, Point(1.0, 25.0));
  EXPECT_EQ(simulator.base().velocity(), Point(0.0, 0.0));
}

TEST(Simulator, CommandHoldsUntilItTimesOut) {
  Simulator simulator(openField(), withPedestrians(0));
  simulator.setCommand({{1.0, 0.0}, 0.0});
  simulator.advance(0.4);
  EXPECT_NEAR(simulator.base().pose().position.x(), 1.4, 1e-9);
  simulator.advance(5.0);  // 0.5 s at 1 m/s in all
  EXPECT_NEAR(simulator.base().pose().position.x(), 1.5, 1e-6);
  EXPECT_EQ(simulator.base().velocity(), Point(0.0, 0.0));
}

TEST(Simulator, CommandRepeatedAtTheTimeoutNeverLapses) {
  Simulator simulator(openField(), withPedestrians(0));
  for (int i = 1; i <= 40; ++i) {
    simulator.setCommand({{1.0, 0.0}, 0.0});
    simulator.advance(0.5);
    ASSERT_EQ(simulator.base().velocity(), Point(1.0, 0.0)) << i;
    ASSERT_NEAR(simulator.base().pose().position.x(), 1.0 + 0.5 * i, 1e-9);
  }
}

TEST(Simulator, RealBaseBrakesAfterTheTimeout) {
  Simulator::Params params = withPedestrians(0);
  params.vehicle.instant_velocity = false;
  Simulator simulator(openField(), params);
  simulator.setCommand({{2.0, 0.0}, 0.0});
  simulator.advance(0.5);
  EXPECT_NEAR(simulator.base().velocity().x(), 0.5, 1e-9);
  simulator.advance(0.25);
  EXPECT_NEAR(simulator.base().velocity().x(), 0.25, 1e-6);
  simulator.advance(1.0);
  EXPECT_EQ(simulator.base().velocity(), Point(0.0, 0.0));
}

TEST(Simulator, CrowdDependsOnTimeAlone) {
  Simulator slow(openField(), withPedestrians(30));
  Simulator fast(openField(), withPedestrians(30));
  for (int i = 0; i < 1200; ++i) {
    slow.setCommand({{2.0, 1.0}, 0.5});
    slow.advance(0.05);
    slow.sense();
  }
  fast.advance(60.0);
  EXPECT_NEAR(slow.time(), 60.0, 1e-9);
  ASSERT_EQ(slow.crowd().walkers().size(), fast.crowd().walkers().size());
  for (size_t k = 0; k < fast.crowd().walkers().size(); ++k) {
    EXPECT_EQ(slow.crowd().walkers()[k].position, fast.crowd().walkers()[k].position);
  }
}

TEST(Simulator, TicksFallOnTenthsOfASecond) {
  Simulator simulator(openField(), withPedestrians(1));
  const Point before = simulator.crowd().walkers().at(0).position;
  simulator.advance(0.06);
  EXPECT_EQ(simulator.crowd().walkers()[0].position, before);
  EXPECT_NEAR(simulator.sense().stamp, 0.0, 1e-12);
  simulator.advance(0.06);
  EXPECT_NE(simulator.crowd().walkers()[0].position, before);
  EXPECT_NEAR(simulator.sense().stamp, 0.1, 1e-12);
  EXPECT_NEAR(simulator.time(), 0.12, 1e-12);
}

TEST(Simulator, PlacedRobotStaysAtRest) {
  Simulator simulator(openField(), withPedestrians(0));
  simulator.setCommand({{1.0, 0.0}, 0.0});
  simulator.placeRobot({{50.0, 50.0}, 1.0});
  simulator.advance(1.0);
  EXPECT_EQ(simulator.base().pose().position, Point(50.0, 50.0));
}

TEST(Simulator, ReplaysATracksFileWithTheTimeOfItsSamples) {
  const TemporaryFile tracks("replay.csv",
                             "time_s,ped_id,x_m,y_m\n0,7,2,25\n0.4,7,2.4,25\n0.8,7,2.8,25\n");
  World world = openField();
  world.tracks_file = tracks.path();
  world.tracks_start_time = 0.1;
  Simulator simulator(world, {});
  EXPECT_NEAR(simulator.sense().stamp, -0.1, 1e-12);
  simulator.advance(0.5);  // 0.6 s in the recording; the last sample is of 0.4 s
  const TrackList list = simulator.sense();
  EXPECT_NEAR(list.stamp, 0.3, 1e-12);
  ASSERT_EQ(list.tracks.size(), 1u);
  EXPECT_EQ(list.tracks[0].position, Point(2.4, 25.0));
  EXPECT_NEAR(list.tracks[0].velocity.x(), 1.0, 1e-9);
  EXPECT_NEAR(simulator.crowd().walkers().at(0).position.x(), 2.6, 1e-9);
}

TEST(Simulator, NamesWhatIsWrong) {
  const World world = openField();
  EXPECT_EQ(messageOf([&] { Simulator(world, withPedestrians(-3)); }),
            "pedestrians must be between 0 and 10000, got -3");
  EXPECT_EQ(messageOf([&] { Simulator(world, withPedestrians(10001)); }),
            "pedestrians must be between 0 and 10000, got 10001");
  Simulator::Params params;
  params.command_timeout = -0.5;
  EXPECT_EQ(messageOf([&] { Simulator(world, params); }),
            "command_timeout must be positive, got -0.5");
  World lost = world;
  lost.tracks_file = "/nowhere/tracks.csv";
  EXPECT_EQ(messageOf([&] { Simulator(lost, {}); }),
            "/nowhere/tracks.csv: the file cannot be read");
  const TemporaryFile elsewhere("elsewhere.csv", "time_s,ped_id,x_m,y_m\n0.0,1,-7.0,5.0\n");
  lost.tracks_file = elsewhere.path();
  EXPECT_NE(messageOf([&] { Simulator(lost, {}); }).find("nobody in it walks on the field"),
            std::string::npos);
  Simulator simulator(world, withPedestrians(0));
  EXPECT_EQ(messageOf([&] { simulator.advance(-0.5); }), "cannot advance by -0.5 s");
}

}  // namespace
}  // namespace pomdp_crowd_nav
