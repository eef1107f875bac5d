// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace pomdp_crowd_nav {

// When a decision is worked out and when it takes effect; all times [s], steady clock.
struct DecisionSlot {
  double start = 0.0;     // the newest inputs are taken and the search begins
  double deadline = 0.0;  // the search ends
  double effect = 0.0;    // the base begins to follow; a decision that is later is dropped
  int left_out = 0;       // slots between this one and the last that were slept through
};

// Decisions take effect at even intervals; each is searched for in the time just before.
class DecisionSchedule {
 public:
  static constexpr double kMargin = 0.05;  // [s] before the search and between search and effect

  // A search that does not fit into the step is shortened.
  DecisionSchedule(double step, double search_time);

  // Holds from the next decision on; a longer search from the one after, for the time of the next
  // may be running already.
  void setSearchTime(double search_time);

  // The first decision takes effect as soon as one can be made from `now` on.
  void restart(double now);

  // The next slot that does not begin before `now`; slots that were slept through are left out.
  DecisionSlot next(double now);

  double step() const { return step_; }
  double searchTime() const { return search_time_; }

 private:
  double step_;
  double search_time_;       // [s], of the next decision
  double next_search_time_;  // [s], of those after it
  double next_effect_ = 0.0;
};

}  // namespace pomdp_crowd_nav
