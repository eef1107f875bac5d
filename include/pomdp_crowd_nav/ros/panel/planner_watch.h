// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "pomdp_crowd_nav/ros/messages.h"
#include "pomdp_crowd_nav/ros/panel/status_texts.h"

namespace pomdp_crowd_nav {

// Whether a planner is there and speaks, judged by its status; all times [s], steady clock.
class PlannerWatch {
 public:
  static constexpr double kSilence = 2.0;  // [s] without a status, which comes twice a second

  // Returns whether this is news: a latched status that comes in again after a new connection is
  // none.
  bool hear(const PlannerStatus& status, double now);

  void setPublishers(int publishers) { publishers_ = publishers; }

  bool isHeard(double now) const { return status_ && silentFor(now) <= kSilence; }
  bool isMissing() const { return publishers_ == 0; }
  double silentFor(double now) const { return status_ ? now - last_news_ : 0.0; }
  const std::optional<PlannerStatus>& status() const { return status_; }

  // What it said last, or that it says nothing; `node`: its name.
  StatusTexts texts(const std::string& node, std::optional<double> deadline, double now) const;

 private:
  std::optional<PlannerStatus> status_;
  double last_news_ = 0.0;
  int publishers_ = 0;
};

}  // namespace pomdp_crowd_nav
