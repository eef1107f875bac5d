// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

namespace pomdp_crowd_nav {

// Of a sample.
struct Summary {
  int count = 0;
  double mean = 0.0;            // NaN without values
  double deviation = 0.0;       // of the sample (n - 1); NaN for fewer than two values
  double standard_error = 0.0;  // of the mean; NaN for fewer than two values
};

Summary summarize(const std::vector<double>& values);

// The probability that a variable with Student's t distribution is at most `t`.
double studentCdf(double t, double degrees_of_freedom);

// The t that such a variable stays below with probability `p` in (0, 1).
double studentQuantile(double p, double degrees_of_freedom);

// Half the width of the interval about the mean that covers the true one with probability
// `confidence`; NaN for fewer than two values.
double halfConfidenceInterval(const Summary& summary, double confidence = 0.95);

}  // namespace pomdp_crowd_nav
