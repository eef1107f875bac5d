// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/evaluation/replay_task.h"

#include <fmt/format.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "pomdp_crowd_nav/params/file_errors.h"

namespace pomdp_crowd_nav {
namespace {

using Json = nlohmann::json;

const Json& member(const Json& item, const char* key) {
  if (item.is_object() && item.contains(key)) return item.at(key);
  throw std::runtime_error(fmt::format("'{}' is missing", key));
}

double numberOf(const Json& value, const char* key) {
  if (value.is_number()) return value.get<double>();
  throw std::runtime_error(fmt::format("'{}': expected a number, got {}", key, value.dump()));
}

double number(const Json& item, const char* key) { return numberOf(member(item, key), key); }

Point point(const Json& item, const char* key) {
  const Json& pair = member(item, key);
  if (pair.is_array() && pair.size() == 2) return {numberOf(pair[0], key), numberOf(pair[1], key)};
  throw std::runtime_error(fmt::format("'{}': expected [x, y], got {}", key, pair.dump()));
}

ReplayTask taskOf(const Json& item) {
  ReplayTask task;
  const Json& person = member(item, "ped_id");
  if (!person.is_number_integer()) {
    throw std::runtime_error("'ped_id': expected a whole number, got " + person.dump());
  }
  task.person = person.get<std::int64_t>();
  task.start_time = number(item, "t_start_s");
  task.start = point(item, "start");
  task.goal = point(item, "goal");
  task.person_time = number(item, "human_time_s");
  task.person_min_distance = number(item, "human_min_distance_m");
  return task;
}

Json parse(std::ifstream& file) {
  try {
    return Json::parse(file);
  } catch (const Json::exception& error) {
    const std::string text = error.what();  // begins with [json.exception...]
    const size_t begin = text.find("] ");
    throw std::runtime_error(begin == std::string::npos ? text : text.substr(begin + 2));
  }
}

}  // namespace

std::vector<ReplayTask> loadReplayTasks(const std::string& path) {
  std::ifstream file(path);
  file.peek();  // fails on a directory
  if (!file.is_open() || file.bad()) throw std::runtime_error(cannotBeRead(path));
  std::vector<ReplayTask> tasks;
  std::string where;  // in the file
  try {
    const Json recording = parse(file);
    const Json& items = member(member(recording, "replace_person_tasks"), "items");
    if (!items.is_array() || items.empty()) throw std::runtime_error("'items' has no task");
    for (const Json& item : items) {
      where = fmt::format("task {}: ", tasks.size() + 1);
      tasks.push_back(taskOf(item));
    }
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(fmt::format("{}: {}{}", path, where, error.what()));
  }
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
