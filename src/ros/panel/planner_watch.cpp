// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/ros/panel/planner_watch.h"

#include <fmt/format.h>

namespace pomdp_crowd_nav {
namespace {

bool isSame(const PlannerStatus& a, const PlannerStatus& b) {
  return a.header.stamp == b.header.stamp && a.clock_age == b.clock_age;
}

}  // namespace

bool PlannerWatch::hear(const PlannerStatus& status, double now) {
  if (status_ && isSame(*status_, status)) return false;
  status_ = status;
  last_news_ = now;
  return true;
}

StatusTexts PlannerWatch::texts(const std::string& node, std::optional<double> deadline,
                                double now) const {
  if (isHeard(now)) return textsOf(*status_, deadline);
  StatusTexts texts;
  texts.mood = Mood::kUnknown;
  if (!status_) {
    texts.state = "no " + node;
    texts.cause = "its status has not been heard";
    return texts;
  }
  texts.state = isMissing() ? "no " + node : fmt::format("silent for {:.0f} s", silentFor(now));
  texts.cause =
      isMissing() ? fmt::format("last heard {:.0f} s ago: {}", silentFor(now), status_->state_name)
                  : fmt::format("{} does not send its status; the last state was {}", node,
                                status_->state_name);
  return texts;
}

}  // namespace pomdp_crowd_nav
