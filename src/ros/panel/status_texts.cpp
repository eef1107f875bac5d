// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/ros/panel/status_texts.h"

#include <fmt/format.h>

namespace pomdp_crowd_nav {
namespace {

Mood moodOf(std::uint8_t state) {
  switch (state) {
    case PlannerStatus::IDLE:
      return Mood::kIdle;
    case PlannerStatus::DRIVING:
      return Mood::kDriving;
    case PlannerStatus::PREPARING:
    case PlannerStatus::WAITING_FOR_PEOPLE:
    case PlannerStatus::PAUSED:
    case PlannerStatus::STOPPING:
      return Mood::kWaiting;
    case PlannerStatus::WAITING_FOR_INPUT:
    case PlannerStatus::BLOCKED:
      return Mood::kTrouble;
    default:
      return Mood::kUnknown;
  }
}

// In steps that can be read while it changes.
std::string ageText(double age, const char* never) {
  if (!(age >= 0.0)) return never;
  return age < 10.0 ? fmt::format("{:.2f} s old", age) : fmt::format("{:.0f} s old", age);
}

std::string decisionText(const PlannerStatus& status, std::optional<double> deadline) {
  if (status.decisions == 0) return "none yet";
  const std::string limit = deadline ? fmt::format(" of {:.2f}", *deadline) : "";
  return fmt::format("{:.3f}{} s, {} trials, {} nodes", status.cycle_time, limit, status.trials,
                     status.tree_size);
}

std::string lateText(const PlannerStatus& status) {
  if (status.decisions == 0 && status.deadline_misses == 0) return "";
  return fmt::format("{} of {} decisions", status.deadline_misses, status.decisions);
}

}  // namespace

StatusTexts textsOf(const PlannerStatus& status, std::optional<double> deadline) {
  StatusTexts texts;
  texts.mood = moodOf(status.state);
  texts.state = status.state_name;
  texts.cause = status.stop_cause;
  texts.decision = decisionText(status, deadline);
  texts.late = lateText(status);
  texts.odometry = ageText(status.odom_age, "none yet");
  texts.people = ageText(status.people_age, "none yet");
  if (status.people_age >= 0.0) texts.people += fmt::format(", {} tracked", status.people);
  texts.map = ageText(status.map_age, "none yet");
  return texts;
}

}  // namespace pomdp_crowd_nav
