// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/evaluation/statistics.h"

#include <gtest/gtest.h>

#include <cmath>

namespace pomdp_crowd_nav {
namespace {

TEST(Statistics, MeanDeviationAndStandardError) {
  const Summary summary = summarize({2.0, 4.0, 4.0, 4.0, 5.0, 5.0, 7.0, 9.0});
  EXPECT_EQ(summary.count, 8);
  EXPECT_DOUBLE_EQ(summary.mean, 5.0);
  EXPECT_NEAR(summary.deviation, std::sqrt(32.0 / 7.0), 1e-12);
  EXPECT_NEAR(summary.standard_error, std::sqrt(32.0 / 7.0 / 8.0), 1e-12);
}

TEST(Statistics, NothingIsSaidOfTooFewValues) {
  EXPECT_TRUE(std::isnan(summarize({}).mean));
  EXPECT_DOUBLE_EQ(summarize({3.0}).mean, 3.0);
  EXPECT_TRUE(std::isnan(summarize({3.0}).standard_error));
  EXPECT_TRUE(std::isnan(halfConfidenceInterval(summarize({3.0}))));
}

// Printed tables of Student's t, two-sided 95 % and 99 %.
TEST(Statistics, QuantilesAreThoseOfTheTables) {
  EXPECT_NEAR(studentQuantile(0.975, 1), 12.7062, 1e-4);
  EXPECT_NEAR(studentQuantile(0.975, 2), 4.30265, 1e-5);
  EXPECT_NEAR(studentQuantile(0.975, 5), 2.57058, 1e-5);
  EXPECT_NEAR(studentQuantile(0.975, 30), 2.04227, 1e-5);
  EXPECT_NEAR(studentQuantile(0.975, 99), 1.98422, 1e-5);
  EXPECT_NEAR(studentQuantile(0.995, 10), 3.16927, 1e-5);
  EXPECT_NEAR(studentQuantile(0.975, 1e7), 1.959964, 1e-5);
  EXPECT_NEAR(studentQuantile(0.025, 5), -2.57058, 1e-5);
  EXPECT_NEAR(studentQuantile(0.5, 5), 0.0, 1e-12);
  EXPECT_THROW(studentQuantile(1.0, 5), std::invalid_argument);
}

// With one degree of freedom it is Cauchy's, with two it has a closed form.
TEST(Statistics, DistributionHasItsClosedForms) {
  for (const double t : {-30.0, -2.0, -0.1, 0.0, 0.3, 1.0, 5.0, 200.0}) {
    EXPECT_NEAR(studentCdf(t, 1), 0.5 + std::atan(t) / M_PI, 1e-12) << t;
    EXPECT_NEAR(studentCdf(t, 2), 0.5 + t / (2.0 * std::sqrt(2.0 + t * t)), 1e-12) << t;
  }
}

TEST(Statistics, AnIntervalOfFivePairs) {
  const Summary summary = summarize({1.0, 2.0, 3.0, 4.0, 5.0});
  EXPECT_NEAR(halfConfidenceInterval(summary), 2.776445 * std::sqrt(0.5), 1e-5);
}

}  // namespace
}  // namespace pomdp_crowd_nav
