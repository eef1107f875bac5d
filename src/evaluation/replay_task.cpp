// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/evaluation/replay_task.h"

#include <fmt/format.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace pomdp_crowd_nav {
namespace {

using Json = nlohmann::json;

Point pointOf(const Json& pair) { return {pair.at(0).get<double>(), pair.at(1).get<double>()}; }

ReplayTask taskOf(const Json& item) {
  ReplayTask task;
  task.person = item.at("ped_id").get<std::int64_t>();
  task.start_time = item.at("t_start_s").get<double>();
  task.start = pointOf(item.at("start"));
  task.goal = pointOf(item.at("goal"));
  task.person_time = item.at("human_time_s").get<double>();
  task.person_min_distance = item.at("human_min_distance_m").get<double>();
  return task;
}

}  // namespace

std::vector<ReplayTask> loadReplayTasks(const std::string& path) {
  std::ifstream file(path);
  if (!file) throw std::runtime_error(fmt::format("{}: cannot be read", path));
  std::vector<ReplayTask> tasks;
  try {
    const Json recording = Json::parse(file);
    for (const Json& item : recording.at("replace_person_tasks").at("items")) {
      tasks.push_back(taskOf(item));
    }
  } catch (const Json::exception& error) {
    throw std::runtime_error(
        fmt::format("{}: expected replace_person_tasks with items: {}", path, error.what()));
  }
  if (tasks.empty()) throw std::runtime_error(fmt::format("{}: has no task", path));
  return tasks;
}

World worldOf(const ReplayTask& task, World world) {
  world.start = {task.start, bearing(task.start, task.goal)};
  world.goal = task.goal;
  world.tracks_start_time = task.start_time;
  world.left_out = {task.person};
  return world;
}

ReplaySummary summarize(const std::vector<ReplayTask>& tasks,
                        const std::vector<EpisodeResult>& results, double contact_distance) {
  ReplaySummary summary;
  summary.tasks = static_cast<int>(tasks.size());
  for (size_t i = 0; i < tasks.size(); ++i) {
    const EpisodeMetrics& metrics = results[i].metrics;
    if (results[i].reachedGoal()) {
      ++summary.arrived;
      summary.mean_time_ratio += metrics.travel_time / tasks[i].person_time;
    }
    if (metrics.min_moving_distance <= contact_distance) ++summary.robot_contacts;
    if (tasks[i].person_min_distance <= contact_distance) ++summary.person_contacts;
  }
  if (summary.arrived > 0) summary.mean_time_ratio /= summary.arrived;
  return summary;
}

}  // namespace pomdp_crowd_nav
