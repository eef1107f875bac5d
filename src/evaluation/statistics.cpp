// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/evaluation/statistics.h"

#include <cmath>
#include <limits>
#include <stdexcept>

namespace pomdp_crowd_nav {
namespace {

constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();

// The continued fraction of the incomplete beta function (DLMF 8.17.22), by the method of Lentz.
double betaFraction(double a, double b, double x) {
  constexpr double kTiny = 1e-300;
  constexpr double kPrecision = 1e-15;
  constexpr int kMaxTerms = 100000;
  const auto keptOffZero = [](double value) { return std::abs(value) < kTiny ? kTiny : value; };
  double c = 1.0;
  double d = 1.0 / keptOffZero(1.0 - (a + b) * x / (a + 1.0));
  double fraction = d;
  for (int m = 1; m < kMaxTerms; ++m) {
    const double even = m * (b - m) * x / ((a + 2.0 * m - 1.0) * (a + 2.0 * m));
    d = 1.0 / keptOffZero(1.0 + even * d);
    c = keptOffZero(1.0 + even / c);
    fraction *= d * c;
    const double odd = -(a + m) * (a + b + m) * x / ((a + 2.0 * m) * (a + 2.0 * m + 1.0));
    d = 1.0 / keptOffZero(1.0 + odd * d);
    c = keptOffZero(1.0 + odd / c);
    const double factor = d * c;
    fraction *= factor;
    if (std::abs(factor - 1.0) < kPrecision) break;
  }
  return fraction;
}

// I_x(a, b)
double regularizedBeta(double a, double b, double x) {
  if (x <= 0.0) return 0.0;
  if (x >= 1.0) return 1.0;
  const double front = std::exp(std::lgamma(a + b) - std::lgamma(a) - std::lgamma(b) +
                                a * std::log(x) + b * std::log1p(-x));
  if (x < (a + 1.0) / (a + b + 2.0)) return front * betaFraction(a, b, x) / a;
  return 1.0 - front * betaFraction(b, a, 1.0 - x) / b;
}

}  // namespace

Summary summarize(const std::vector<double>& values) {
  Summary summary;
  summary.count = static_cast<int>(values.size());
  summary.mean = summary.deviation = summary.standard_error = kNothing;
  if (values.empty()) return summary;
  double sum = 0.0;
  for (const double value : values) sum += value;
  summary.mean = sum / summary.count;
  if (values.size() < 2) return summary;
  double squares = 0.0;
  for (const double value : values) squares += (value - summary.mean) * (value - summary.mean);
  summary.deviation = std::sqrt(squares / (summary.count - 1));
  summary.standard_error = summary.deviation / std::sqrt(summary.count);
  return summary;
}

double studentCdf(double t, double degrees_of_freedom) {
  const double x = degrees_of_freedom / (degrees_of_freedom + t * t);
  const double tail = 0.5 * regularizedBeta(0.5 * degrees_of_freedom, 0.5, x);
  return t > 0.0 ? 1.0 - tail : tail;
}

double studentQuantile(double p, double degrees_of_freedom) {
  if (!(p > 0.0 && p < 1.0) || !(degrees_of_freedom > 0.0)) {
    throw std::invalid_argument("a quantile needs p in (0, 1) and degrees of freedom above 0");
  }
  if (p < 0.5) return -studentQuantile(1.0 - p, degrees_of_freedom);
  double low = 0.0;
  double high = 1.0;
  while (studentCdf(high, degrees_of_freedom) < p) high *= 2.0;
  for (int i = 0; i < 200 && low < high; ++i) {
    const double middle = 0.5 * (low + high);
    if (middle == low || middle == high) break;
    (studentCdf(middle, degrees_of_freedom) < p ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

double halfConfidenceInterval(const Summary& summary, double confidence) {
  if (summary.count < 2) return kNothing;
  return summary.standard_error * studentQuantile(0.5 * (1.0 + confidence), summary.count - 1.0);
}

}  // namespace pomdp_crowd_nav
