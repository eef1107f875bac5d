// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/ros/decision_schedule.h"

#include <algorithm>
#include <cmath>

namespace pomdp_crowd_nav {

DecisionSchedule::DecisionSchedule(double step, double search_time)
    : step_(step),
      search_time_(std::min(search_time, step - 3.0 * kMargin)),
      next_search_time_(search_time_) {}

void DecisionSchedule::setSearchTime(double search_time) {
  next_search_time_ = std::min(search_time, step_ - 3.0 * kMargin);
  search_time_ = std::min(search_time_, next_search_time_);
}

void DecisionSchedule::restart(double now) {
  search_time_ = next_search_time_;
  next_effect_ = now + search_time_ + 2.0 * kMargin;
}

DecisionSlot DecisionSchedule::next(double now) {
  const double lead = search_time_ + kMargin;
  const double late = now - (next_effect_ - lead);
  const int left_out = late > kMargin ? static_cast<int>(std::ceil((late - kMargin) / step_)) : 0;
  next_effect_ += step_ * left_out;
  const DecisionSlot slot{next_effect_ - lead, next_effect_ - kMargin, next_effect_, left_out};
  next_effect_ += step_;
  search_time_ = next_search_time_;
  return slot;
}

}  // namespace pomdp_crowd_nav
