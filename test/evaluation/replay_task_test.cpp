// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/evaluation/replay_task.h"

#include <gtest/gtest.h>

#include "../recordings.h"
#include "../sim/temporary_file.h"
#include "pomdp_crowd_nav/params/yaml_param_reader.h"

namespace pomdp_crowd_nav {
namespace {

TEST(ReplayTask, ReadsWhatARecordingAsks) {
  const TemporaryFile file(
      "tasks.json",
      R"({"replace_person_tasks": {"items": [{"ped_id": 7, "t_start_s": 2.5, "start": [1, 2],
          "goal": [3, 4], "human_time_s": 6.0, "human_min_distance_m": 0.5}]}})");
  const std::vector<ReplayTask> tasks = loadReplayTasks(file.path());
  ASSERT_EQ(tasks.size(), 1U);
  const World world = worldOf(tasks[0], World());
  EXPECT_EQ(world.start.position, Point(1.0, 2.0));
  EXPECT_NEAR(world.start.heading, M_PI / 4.0, 1e-12);
  EXPECT_EQ(world.goal, Point(3.0, 4.0));
  EXPECT_EQ(world.tracks_start_time, 2.5);
  EXPECT_EQ(world.left_out, std::vector<std::int64_t>{7});
}

TEST(ReplayTask, SaysWhatIsWrongInItsOwnWords) {
  const auto messageFor = [](const std::string& items) {
    const TemporaryFile file("tasks.json", R"({"replace_person_tasks": {"items": )" + items + "}}");
    const std::string message = messageOf([&] { loadReplayTasks(file.path()); });
    return message.substr(message.find(": ") + 2);
  };
  EXPECT_EQ(messageFor("[]"), "'items' has no task");
  EXPECT_EQ(messageFor("[{}]"), "task 1: 'ped_id' is missing");
  EXPECT_EQ(messageFor(R"([{"ped_id": 1.5}])"),
            "task 1: 'ped_id': expected a whole number, got 1.5");
  EXPECT_EQ(messageFor(R"([{"ped_id": 1, "t_start_s": "soon"}])"),
            "task 1: 't_start_s': expected a number, got \"soon\"");
  EXPECT_EQ(messageFor(R"([{"ped_id": 1, "t_start_s": 0, "start": [1]}])"),
            "task 1: 'start': expected [x, y], got [1]");
  EXPECT_EQ(messageFor("[").rfind("parse error at line 1", 0), 0u) << messageFor("[");
}

TEST(ReplayTask, NamesTheFileThatIsWrong) {
  const TemporaryFile file("tasks.json", R"({"replace_person_tasks": {"items": [{"ped_id": 7}]}})");
  try {
    loadReplayTasks(file.path());
    FAIL() << "a task without a start was taken";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find(file.path()), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("t_start_s"), std::string::npos) << error.what();
  }
}

TEST(ReplayTask, SummaryComparesRobotAndPerson) {
  std::vector<ReplayTask> tasks(3);
  std::vector<EpisodeResult> results(3);
  for (int i = 0; i < 3; ++i) {
    tasks[i].person_time = 10.0;
    tasks[i].person_min_distance = 0.5 + 0.2 * i;
    results[i].end = i < 2 ? EpisodeEnd::kGoalReached : EpisodeEnd::kTimeLimit;
    results[i].metrics.travel_time = 10.0 + 4.0 * i;
    results[i].metrics.min_moving_distance = i == 2 ? 0.4 : 0.9;
  }
  const ReplaySummary summary = summarize(tasks, results, 0.6);
  EXPECT_EQ(summary.arrived, 2);
  EXPECT_NEAR(summary.mean_time_ratio, 1.2, 1e-12);
  EXPECT_EQ(summary.robot_contacts, 1);
  EXPECT_EQ(summary.person_contacts, 1);
}

// The bounds are those that the project set itself for this recording.
TEST(ReplayTask, RobotTakesThePlaceOfPeopleInZara01) {
  const std::string tracks = recordingPath("ucy_zara01.csv");
  if (!isThere(tracks)) GTEST_SKIP() << tracks << " is absent; set UCY_DATA_DIR to its folder";
  auto reader = YamlParamReader::fromFile(SOURCE_DIR "/config/profiles/street.yaml");
  EpisodeParams params;
  params.navigation = loadNavigationParams(reader);
  params.simulator = loadSimulatorParams(reader, params.navigation.planning.model.vehicle);
  params.max_trials = 100;
  params.time_limit = 120.0;
  World world = loadWorld(SOURCE_DIR "/config/worlds/ucy_zara01.yaml");
  world.tracks_file = tracks;

  const std::vector<ReplayTask> tasks = loadReplayTasks(recordingPath("ucy_zara01.json"));
  std::vector<EpisodeResult> results;
  for (const ReplayTask& task : tasks) results.push_back(runEpisode(worldOf(task, world), params));
  const ReplaySummary summary = summarize(tasks, results, 0.6);
  EXPECT_GE(summary.arrived, 27);
  EXPECT_LE(summary.mean_time_ratio, 1.5);
  EXPECT_LE(summary.robot_contacts, summary.person_contacts + 1);
}

}  // namespace
}  // namespace pomdp_crowd_nav
