// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

namespace pomdp_crowd_nav {

// Wall clock of the newest decisions. A status repeats the last decision until there is another:
// each counts once.
class CycleHistory {
 public:
  static constexpr std::size_t kMost = 60;

  // `decisions`: made since the goal was accepted; fewer than before: another trip. `cycle_time`
  // [s].
  void add(std::uint32_t decisions, double cycle_time);

  const std::deque<double>& times() const { return times_; }  // [s], oldest first

 private:
  std::uint32_t decisions_ = 0;
  std::deque<double> times_;
};

// The history as bars in a box whose y axis points down, the newest at the right edge.
struct CycleBars {
  struct Bar {
    double left = 0.0, top = 0.0;  // [px]; it stands on the bottom of the box
    bool is_late = false;
  };
  double width = 0.0;                  // [px], of a bar
  std::vector<Bar> bars;               // oldest first
  std::optional<double> deadline_top;  // [px], of the line
};

// `deadline` [s]: until when a decision must be there, where that is known.
CycleBars barsOf(const CycleHistory& history, std::optional<double> deadline, double box_width,
                 double box_height);

}  // namespace pomdp_crowd_nav
