// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/ros/status_reporter.h"

#include <diagnostic_msgs/DiagnosticStatus.h>
#include <ros/console.h>

#include <exception>
#include <iterator>

namespace pomdp_crowd_nav {

using diagnostic_msgs::DiagnosticStatus;
using diagnostic_updater::DiagnosticStatusWrapper;

namespace {

std::uint8_t levelOf(InputHealth::Level level) {
  switch (level) {
    case InputHealth::Level::kWarning:
      return DiagnosticStatus::WARN;
    case InputHealth::Level::kError:
      return DiagnosticStatus::ERROR;
    default:
      return DiagnosticStatus::OK;
  }
}

}  // namespace

StatusReporter::StatusReporter(ros::NodeHandle& node, ros::NodeHandle& private_node,
                               const std::string& hardware_id)
    : publisher_(private_node.advertise<PlannerStatus>("status", 10, true)),
      updater_(node, private_node) {
  updater_.setHardwareID(hardware_id);
  updater_.add("navigation state", this, &StatusReporter::diagnoseState);
  updater_.add("planning cycle", this, &StatusReporter::diagnoseTiming);
  for (size_t i = 0; i < std::size(kInputNames); ++i) {
    updater_.add(kInputNames[i],
                 [this, i](DiagnosticStatusWrapper& out) { diagnoseInput(i, out); });
  }
}

void StatusReporter::publish(PlannerStatus status) {
  status.header.stamp = ros::Time::now();
  const std::lock_guard<std::mutex> lock(mutex_);
  status_ = status;
  publisher_.publish(status);
}

void StatusReporter::publishDiagnostics(std::vector<InputHealth> inputs) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    inputs_ = std::move(inputs);
  }
  try {
    updater_.force_update();
  } catch (const std::exception& error) {  // it throws when ROS time is near its end
    ROS_WARN_THROTTLE(10.0, "diagnostics: %s", error.what());
  }
}

PlannerStatus StatusReporter::newest() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return status_;
}

void StatusReporter::diagnoseState(DiagnosticStatusWrapper& out) {
  const PlannerStatus status = newest();
  const bool lacks_input = status.state == PlannerStatus::WAITING_FOR_INPUT;
  const bool is_blocked = status.state == PlannerStatus::BLOCKED;
  const auto level = is_blocked ? DiagnosticStatus::WARN : DiagnosticStatus::OK;
  out.summary(
      lacks_input ? DiagnosticStatus::ERROR : level,
      status.stop_cause.empty() ? status.state_name : status.state_name + ": " + status.stop_cause);
  out.add("people", status.people);
  out.add("tracks left out, position not finite or out of range", status.bad_people);
  out.add("tracks left out, id given twice", status.duplicate_ids);
  out.add("tracks left out, too many", status.surplus_people);
  out.add("jumps of the clock", status.clock_jumps);
  out.add("blocking person", status.blocking_person);
  out.add("blocked for [s]", status.blocked_for);
}

void StatusReporter::diagnoseTiming(DiagnosticStatusWrapper& out) {
  const PlannerStatus status = newest();
  constexpr double kManyMisses = 0.05;  // share of the decisions
  const bool misses_many = status.deadline_misses > kManyMisses * status.decisions;
  out.summary(misses_many ? DiagnosticStatus::WARN : DiagnosticStatus::OK,
              misses_many ? "decisions come too late" : "decisions come in time");
  out.add("decisions", status.decisions);
  out.add("deadline misses", status.deadline_misses);
  out.add("sudden brakes", status.sudden_brakes);
  out.add("last cycle [s]", status.cycle_time);
  out.add("trials", status.trials);
  out.add("tree size", status.tree_size);
}

void StatusReporter::diagnoseInput(size_t index, DiagnosticStatusWrapper& out) {
  InputHealth input;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (index < inputs_.size()) input = inputs_[index];
  }
  out.summary(levelOf(input.level), input.text);
  if (!input.topic.empty()) out.add("topic", input.topic);
  if (!input.frame.empty()) out.add("frame", input.frame);
  out.add("age [s]", input.age);
  out.add("age limit [s]", input.limit);
  out.add("rate [Hz]", input.rate);
  out.add("refused", input.refused);
  out.add("last refused because", input.last_fault);
}

}  // namespace pomdp_crowd_nav
