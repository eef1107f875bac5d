// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <list>
#include <string>
#include <vector>

#include "../instrumented.h"
#include "command_meter.h"
#include "navigation_client.h"

namespace pomdp_crowd_nav {

// One row of the fault matrix in doc/safety.md, from which a test compares name and bound: write
// both as literals. One to each test, whose results have room for one.
struct Fault {
  std::string name;    // as in the first column there
  double bound = 0.0;  // [s], from the fault to rest; for one that stops nothing, between commands
};

inline void recordFault(const Fault& fault, const char* measured, double value) {
  testing::Test::RecordProperty("fault", fault.name);
  testing::Test::RecordProperty("bound_s", fmt::format("{:.2f}", fault.bound));
  testing::Test::RecordProperty(measured, fmt::format("{:.2f}", value));
}

// Call at the moment of the fault: fails unless the base is at rest within the bound, and leaves
// what was measured in the test's results, from where scripts/fault_matrix.py takes it.
inline void expectRest(const Fault& fault, const std::function<bool()>& is_at_rest) {
  constexpr double kPatience = 5.0;  // [s] beyond the bound, to say by how much it was missed
  const ros::WallTime begin = ros::WallTime::now();
  const bool rests = NavigationClient::waitUntil(fault.bound + kPatience, is_at_rest);
  const double took = (ros::WallTime::now() - begin).toSec();
  EXPECT_TRUE(rests) << fault.name << ": the base never came to rest";
  EXPECT_LE(took, fault.bound) << fault.name;
  recordFault(fault, "rest_s", took);
}

// The worst of several robots.
inline CommandMeter::Reading worstOf(const std::list<CommandMeter>& meters) {
  CommandMeter::Reading worst = meters.front().reading();
  for (const CommandMeter& meter : meters) {
    const CommandMeter::Reading reading = meter.reading();
    worst.commands = std::min(worst.commands, reading.commands);
    worst.longest_period = std::max(worst.longest_period, reading.longest_period);
    worst.least_speed = std::min(worst.least_speed, reading.least_speed);
  }
  return worst;
}

// Fails where a base nearly came to rest, as on a hard stop, or, instrumented, got no command.
inline void expectNoHardStop(const CommandMeter::Reading& reading) {
  constexpr double kStillDrives = 0.3;  // [m/s]
  EXPECT_GT(reading.commands, 0);
  if (kIsInstrumented) return;
  EXPECT_GT(reading.least_speed, kStillDrives) << "a hard stop";
}

// For a fault that should stop nothing: fails unless the bases, in these namespaces, keep moving
// while `injure` runs, which is not asked of instrumented nodes, and commands come no more than the
// bound apart. Up to three times, as other
// work on the machine may delay a command, and the best counts; what the node itself delays, it
// delays each time.
inline CommandMeter::Reading expectDriveOn(const Fault& fault, const std::function<void()>& injure,
                                           const std::vector<std::string>& spaces = {""}) {
  constexpr int kAttempts = 3;
  CommandMeter::Reading best;
  double rate = 0.0;  // [Hz]
  const auto moves = [&best] { return kIsInstrumented || best.least_speed > 0.0; };
  for (int i = 0; i < kAttempts; ++i) {
    std::list<CommandMeter> meters;
    for (const std::string& space : spaces) meters.emplace_back(space);
    const ros::WallTime begin = ros::WallTime::now();
    injure();
    const CommandMeter::Reading reading = worstOf(meters);
    if (i > 0 && reading.longest_period > best.longest_period) continue;
    best = reading;
    rate = reading.commands / (ros::WallTime::now() - begin).toSec();
    if (rate > 15.0 && moves() && best.longest_period <= fault.bound) break;
  }
  EXPECT_GT(rate, 15.0) << fault.name << ": fewer than 15 commands a second";
  EXPECT_TRUE(moves()) << fault.name << ": the base came to rest, " << best.least_speed << " m/s";
  EXPECT_LE(best.longest_period, fault.bound) << fault.name;
  recordFault(fault, "period_s", best.longest_period);
  return best;
}

// The same for a fault that lasts already, over `duration` [s].
inline void expectDriveOn(const Fault& fault, double duration,
                          const std::vector<std::string>& spaces = {""}) {
  expectDriveOn(
      fault, [=] { NavigationClient::waitUntil(duration, [] { return false; }); }, spaces);
}

}  // namespace pomdp_crowd_nav
