// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/despot/search_params.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <string>

#include "pomdp_crowd_nav/despot/search_result.h"

namespace pomdp_crowd_nav {
namespace {

template <class Field>
std::string messageFor(Field SearchParams::*field, Field value) {
  SearchParams params;
  params.*field = value;
  try {
    validate(params);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "accepted";
}

TEST(SearchParams, DefaultsAreValid) { EXPECT_NO_THROW(validate(SearchParams())); }

TEST(SearchParams, NamesTheFieldThatIsOutOfRange) {
  EXPECT_EQ(messageFor(&SearchParams::scenarios, 0),
            "search/scenarios must be between 1 and 65535, got 0");
  EXPECT_EQ(messageFor(&SearchParams::scenarios, 65536),
            "search/scenarios must be between 1 and 65535, got 65536");
  EXPECT_EQ(messageFor(&SearchParams::max_depth, -1),
            "search/max_depth must be between 0 and 30000, got -1");
  EXPECT_EQ(messageFor(&SearchParams::max_depth, 30001),
            "search/max_depth must be between 0 and 30000, got 30001");
  EXPECT_NE(messageFor(&SearchParams::discount, 1.0), "accepted");
  EXPECT_NE(messageFor(&SearchParams::discount, 0.0), "accepted");
  EXPECT_NE(messageFor(&SearchParams::target_gap, 1.0), "accepted");
  EXPECT_EQ(messageFor(&SearchParams::discount, 1.5), "search/discount must be in (0, 1), got 1.5");
  EXPECT_EQ(messageFor(&SearchParams::regularization, -0.5),
            "search/regularization must be at least 0, got -0.5");
  EXPECT_EQ(messageFor(&SearchParams::target_gap, 1.25),
            "search/target_gap must be in [0, 1), got 1.25");
  EXPECT_EQ(messageFor(&SearchParams::max_nodes, 0), "search/max_nodes must be at least 1, got 0");
}

TEST(SearchParams, NanIsOutOfRange) {
  const double nan = std::nan("");
  EXPECT_EQ(messageFor(&SearchParams::discount, nan), "search/discount must be in (0, 1), got nan");
  EXPECT_EQ(messageFor(&SearchParams::regularization, nan),
            "search/regularization must be at least 0, got nan");
  EXPECT_EQ(messageFor(&SearchParams::target_gap, nan),
            "search/target_gap must be in [0, 1), got nan");
  EXPECT_EQ(messageFor(&SearchParams::max_memory, nan),
            "search/max_memory must be positive, got nan");
}

TEST(SearchParams, AcceptsTheEndsOfTheRanges) {
  EXPECT_EQ(messageFor(&SearchParams::scenarios, 1), "accepted");
  EXPECT_EQ(messageFor(&SearchParams::scenarios, 65535), "accepted");
  EXPECT_EQ(messageFor(&SearchParams::max_depth, 0), "accepted");
  EXPECT_EQ(messageFor(&SearchParams::regularization, 0.0), "accepted");
  EXPECT_EQ(messageFor(&SearchParams::target_gap, 0.0), "accepted");
  EXPECT_EQ(messageFor(&SearchParams::max_nodes, 1), "accepted");
  EXPECT_EQ(messageFor(&SearchParams::threads, 64), "accepted");
}

TEST(SearchStop, HasANameEach) {
  EXPECT_STREQ(describe(SearchStop::kGapClosed), "gap closed");
  EXPECT_STREQ(describe(SearchStop::kTrialLimit), "trial limit");
  EXPECT_STREQ(describe(SearchStop::kDeadline), "deadline");
  EXPECT_STREQ(describe(SearchStop::kNodeLimit), "node limit");
  EXPECT_STREQ(describe(SearchStop::kLowerBound), "lower bound reached");
}

}  // namespace
}  // namespace pomdp_crowd_nav
