// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <diagnostic_msgs/DiagnosticArray.h>
#include <ros/ros.h>

#include <map>
#include <string>

namespace pomdp_crowd_nav {

// The newest level and text of each task on /diagnostics.
class DiagnosticsListener {
 public:
  using Status = diagnostic_msgs::DiagnosticStatus;

  DiagnosticsListener() {
    subscriber_ = node_.subscribe("/diagnostics", 100, &DiagnosticsListener::onArray, this);
  }

  // Of the task of that node; -1 before the first message.
  int level(const std::string& task, const std::string& node = "planner_node") const {
    const auto found = tasks_.find(node + ": " + task);
    return found == tasks_.end() ? -1 : found->second.level;
  }

  std::string text(const std::string& task, const std::string& node = "planner_node") const {
    const auto found = tasks_.find(node + ": " + task);
    return found == tasks_.end() ? "" : found->second.message;
  }

  std::string value(const std::string& task, const std::string& key,
                    const std::string& node = "planner_node") const {
    const auto found = tasks_.find(node + ": " + task);
    if (found == tasks_.end()) return "";
    for (const auto& pair : found->second.values) {
      if (pair.key == key) return pair.value;
    }
    return "";
  }

 private:
  void onArray(const diagnostic_msgs::DiagnosticArray& array) {
    for (const Status& status : array.status) tasks_[status.name] = status;
  }

  ros::NodeHandle node_;
  ros::Subscriber subscriber_;
  std::map<std::string, Status> tasks_;
};

}  // namespace pomdp_crowd_nav
