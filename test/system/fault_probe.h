// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <functional>
#include <string>

#include "navigation_client.h"

namespace pomdp_crowd_nav {

// One row of the fault matrix in doc/safety.md.
struct Fault {
  std::string name;    // as in the first column there
  double bound = 0.0;  // [s], from the fault to rest
};

// Call at the moment of the fault: fails unless the base is at rest within the bound, and leaves
// what was measured in the test's results, from where scripts/fault_matrix.py takes it.
inline void expectRest(const Fault& fault, const std::function<bool()>& is_at_rest) {
  constexpr double kPatience = 5.0;  // [s] beyond the bound, to say by how much it was missed
  const ros::WallTime begin = ros::WallTime::now();
  const bool rests = NavigationClient::waitUntil(fault.bound + kPatience, is_at_rest);
  const double took = (ros::WallTime::now() - begin).toSec();
  EXPECT_TRUE(rests) << fault.name << ": the base never came to rest";
  EXPECT_LE(took, fault.bound) << fault.name;
  testing::Test::RecordProperty("fault", fault.name);
  testing::Test::RecordProperty("bound_s", fmt::format("{:.2f}", fault.bound));
  testing::Test::RecordProperty("rest_s", fmt::format("{:.2f}", took));
}

}  // namespace pomdp_crowd_nav
