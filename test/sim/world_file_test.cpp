// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/sim/world_file.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "temporary_file.h"

namespace pomdp_crowd_nav {
namespace {

const std::string kWorlds = SOURCE_DIR "/config/worlds/";
const std::string kBounds = "bounds: {min: [0, 0], max: [10, 10]}\n";
const std::string kWay = "start: [1, 2, 0.5]\ngoal: [9, 9]\n";
const std::string kDestinations = "destinations: [[0, 0]]\n";

World loadText(const std::string& text) {
  const TemporaryFile file("world.yaml", text);
  return loadWorld(file.path());
}

// The error without the path of the file.
std::string errorFor(const std::string& text) {
  const TemporaryFile file("world.yaml", text);
  const std::string message = messageOf([&] { loadWorld(file.path()); });
  EXPECT_EQ(message.compare(0, file.path().size(), file.path()), 0) << message;
  EXPECT_EQ(message.find('\n'), std::string::npos);
  return message.substr(file.path().size());
}

TEST(WorldFile, ReadsEverything) {
  const World world = loadText(kBounds + kWay +
                               "destinations: [[0, 0], [10, 10]]\n"
                               "circles: [[5, 5, 1]]\n"
                               "polygons:\n"
                               "  - {closed: false, vertices: [[3, 3], [4, 3]]}\n"
                               "  - {vertices: [[6, 6], [7, 6], [7, 7]]}\n"
                               "tracks: {file: people.csv, start_time: 4.5, left_out: [3, 12]}\n");
  EXPECT_EQ(world.name, "pomdp_crowd_nav_world");
  EXPECT_EQ(world.bounds.max, Point(10.0, 10.0));
  EXPECT_EQ(world.start.position, Point(1.0, 2.0));
  EXPECT_EQ(world.start.heading, 0.5);
  EXPECT_EQ(world.goal, Point(9.0, 9.0));
  EXPECT_EQ(world.destinations.size(), 2u);
  EXPECT_EQ(world.obstacles.circles.at(0).radius, 1.0);
  ASSERT_EQ(world.obstacles.polygons.size(), 2u);
  EXPECT_FALSE(world.obstacles.polygons[0].closed);
  EXPECT_TRUE(world.obstacles.polygons[1].closed);
  EXPECT_EQ(world.tracks_start_time, 4.5);
  EXPECT_EQ(world.left_out, (std::vector<std::int64_t>{3, 12}));
}

TEST(WorldFile, TracksFileIsRelativeToTheWorldFile) {
  const std::string text = kBounds + kWay + kDestinations;
  EXPECT_EQ(loadText(text).tracks_file, "");
  const std::string relative = loadText(text + "tracks: {file: people.csv}\n").tracks_file;
  EXPECT_EQ(std::filesystem::path(relative).filename(), "people.csv");
  EXPECT_TRUE(std::filesystem::equivalent(std::filesystem::path(relative).parent_path(),
                                          std::filesystem::path(::testing::TempDir())));
  EXPECT_EQ(loadText(text + "tracks: {file: /data/people.csv}\n").tracks_file, "/data/people.csv");
}

TEST(WorldFile, EveryShippedWorldLoads) {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(kWorlds)) {
    SCOPED_TRACE(entry.path().string());
    const World world = loadWorld(entry.path().string());
    EXPECT_EQ(world.name, entry.path().stem().string());
    EXPECT_GE(world.destinations.size(), 2u);
    ++count;
  }
  EXPECT_GE(count, 5);
}

TEST(WorldFile, PaperScenarios) {
  const World open = loadWorld(kWorlds + "scenario_1.yaml");
  EXPECT_FALSE(open.map().hasObstacles());
  EXPECT_EQ(open.start.position, Point(1.0, 25.0));
  EXPECT_EQ(open.goal, Point(100.0, 75.0));
  EXPECT_EQ(open.destinations, (std::vector<Point>{{0, 0}, {0, 100}, {100, 100}, {100, 0}}));
  EXPECT_EQ(loadWorld(kWorlds + "scenario_2.yaml").obstacles.circles.size(), 6u);
  const World corridor = loadWorld(kWorlds + "scenario_3.yaml");
  EXPECT_NEAR(corridor.map().clearance({65.0, 75.0}), 5.0, 1e-9);
}

TEST(WorldFile, ShopIsSolidAndItsPassageIsOpen) {
  const StaticMap map = loadWorld(kWorlds + "ucy_zara01.yaml").map();
  EXPECT_LE(map.clearance({6.0, 12.0}), 0.0);   // inside the shop
  EXPECT_LE(map.clearance({3.5, 1.0}), 0.0);    // inside the parked car
  EXPECT_GT(map.clearance({12.2, 12.0}), 0.2);  // in the passage
  EXPECT_GT(map.clearance({7.0, 5.0}), 2.0);    // on the street
}

TEST(WorldFile, NamesWhatIsMissing) {
  EXPECT_EQ(errorFor(kWay + kDestinations), ": bounds/min: missing, expected [x, y]");
  EXPECT_EQ(errorFor(kBounds + "goal: [1, 1]\n"), ": start: missing, expected [x, y, heading]");
  EXPECT_EQ(errorFor(kBounds + kWay), ": destinations: missing, expected a list of [x, y]");
  EXPECT_EQ(messageOf([] { loadWorld("/nowhere/w.yaml"); }),
            "/nowhere/w.yaml: the file cannot be read");
}

TEST(WorldFile, NamesWhatDoesNotFit) {
  const std::string good = kBounds + kWay + kDestinations;
  EXPECT_EQ(errorFor(good + "circle: [[1, 2, 3]]\n"),
            ": unknown key 'circle', did you mean 'circles'?");
  EXPECT_EQ(errorFor(good + "circles: [[1, 2]]\n"),
            ": circles: expected a list of [x, y, radius], got '[1, 2]'");
  EXPECT_EQ(errorFor(good + "polygons: [{vertexes: [[1, 2]]}]\n"),
            ": unknown key 'polygons/0/vertexes', did you mean 'polygons/0/vertices'?");
  EXPECT_EQ(errorFor(good + "tracks: {left_out: [1.5]}\n"),
            ": tracks/left_out: expected a list of whole numbers, got '[1.5]'");
  EXPECT_EQ(errorFor(good + "tracks: {left_out: [1e300]}\n"),
            ": tracks/left_out: expected a list of whole numbers, got '[1e+300]'");
  EXPECT_EQ(errorFor(kBounds + "start: [1, 2]\n"),
            ": start: expected [x, y, heading], got '[1, 2]'");
  EXPECT_EQ(errorFor(kBounds + "start: [1, two, 0]\n"),
            ": start: expected a list of finite numbers, got '[1, two, 0]'");
}

TEST(WorldFile, RejectsWhatIsOutOfThisWorld) {
  const std::string far = "nothing farther away than 1e6 m, got '";
  EXPECT_EQ(errorFor("bounds: {min: [-2e6, 0], max: [10, 10]}\n" + kWay + kDestinations),
            ": bounds/min: expected " + far + "[-2e+06, 0]'");
  EXPECT_EQ(errorFor(kBounds + kWay + "destinations: [[0, 1e308]]\n"),
            ": destinations: expected " + far + "[0, 1e+308]'");
  EXPECT_EQ(errorFor(kBounds + kWay + kDestinations + "circles: [[1e7, 0, 1]]\n"),
            ": circles: expected " + far + "[1e+07, 0]'");
  EXPECT_EQ(errorFor(kBounds + kWay + kDestinations +
                     "polygons: [{vertices: [[0, 0], [1, 0], "
                     "[1, -1e9]]}]\n"),
            ": polygons: expected " + far + "[1, -1e+09]'");
}

TEST(WorldFile, StartAndGoalAreFree) {
  EXPECT_EQ(errorFor(kBounds + kDestinations + "start: [-1, 2, 0]\ngoal: [9, 9]\n"),
            ": start: expected a point inside the bounds, got '[-1, 2]'");
  EXPECT_EQ(errorFor(kBounds + kWay + kDestinations + "circles: [[9, 8, 2]]\n"),
            ": goal: expected a point outside the obstacles, got '[9, 9]'");
}

TEST(WorldFile, MapErrorsNameTheFile) {
  const std::string message = errorFor(kBounds + kWay + kDestinations + "circles: [[5, 5, -1]]\n");
  EXPECT_EQ(message.compare(0, 2, ": "), 0);
  EXPECT_NE(message.find("radius"), std::string::npos) << message;
}

}  // namespace
}  // namespace pomdp_crowd_nav
