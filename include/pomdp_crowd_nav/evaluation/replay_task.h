// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "pomdp_crowd_nav/evaluation/episode.h"

namespace pomdp_crowd_nav {

// A trip in which the robot takes the place of one recorded person, who is left out of the replay:
// the crowd made room for that person, and the person is the yardstick.
struct ReplayTask {
  std::int64_t person = 0;
  double start_time = 0.0;           // [s] in the recording
  Point start{0.0, 0.0};             // [m]
  Point goal{0.0, 0.0};              // [m]
  double person_time = 0.0;          // [s] the person took
  double person_min_distance = 0.0;  // [m] to anybody on the way
};

// Reads "replace_person_tasks" of a recording's json file. Throws std::runtime_error with one line
// that names the file and what is wrong with it.
std::vector<ReplayTask> loadReplayTasks(const std::string& path);

// The world of a task: the recording's, started at the task's time without the person.
World worldOf(const ReplayTask& task, World world);

// Results of all tasks of a recording beside the people they replace.
struct ReplaySummary {
  int tasks = 0;
  int arrived = 0;
  double mean_time_ratio = 0.0;  // robot's over person's time, over those that arrived
  int robot_contacts = 0;        // tasks with the moving robot within the contact distance
  int person_contacts = 0;       // tasks with the person within it
};

ReplaySummary summarize(const std::vector<ReplayTask>& tasks,
                        const std::vector<EpisodeResult>& results, double contact_distance);

}  // namespace pomdp_crowd_nav
