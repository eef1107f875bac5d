// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/ros/panel/cycle_history.h"

#include <algorithm>
#include <cmath>

namespace pomdp_crowd_nav {
namespace {

constexpr double kHeadroom = 1.25;  // top of the box over the deadline
constexpr double kLeast = 1.0;      // [px], height of a bar: that a decision was made is to be seen

}  // namespace

void CycleHistory::add(std::uint32_t decisions, double cycle_time) {
  const bool is_new = decisions != decisions_ && decisions > 0;
  decisions_ = decisions;
  if (!is_new || !std::isfinite(cycle_time) || cycle_time < 0.0) return;
  times_.push_back(cycle_time);
  if (times_.size() > kMost) times_.pop_front();
}

CycleBars barsOf(const CycleHistory& history, std::optional<double> deadline, double box_width,
                 double box_height) {
  const std::deque<double>& times = history.times();
  const double longest = times.empty() ? 0.0 : *std::max_element(times.begin(), times.end());
  const double top = std::max({longest, kHeadroom * deadline.value_or(0.0), 1e-3});
  const auto height = [&](double time) { return box_height * (1.0 - time / top); };
  CycleBars bars;
  bars.width = box_width / CycleHistory::kMost;
  double left = box_width - bars.width * static_cast<double>(times.size());
  for (const double time : times) {
    const double bar_top = std::min(height(time), box_height - kLeast);
    bars.bars.push_back({left, bar_top, deadline && time > *deadline});
    left += bars.width;
  }
  if (deadline) bars.deadline_top = height(*deadline);
  return bars;
}

}  // namespace pomdp_crowd_nav
