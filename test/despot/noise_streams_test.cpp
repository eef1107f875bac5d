// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/despot/noise_streams.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <set>
#include <vector>

namespace pomdp_crowd_nav {
namespace {

TEST(NoiseStreams, IsAFunctionOfSeedAndAddress) {
  const NoiseStreams noise(7);
  const std::uint64_t later = noise.bits(3, 14, 2);
  noise.bits(99, 99, 5);
  EXPECT_EQ(noise.bits(3, 14, 2), later);
  EXPECT_EQ(NoiseStreams(7).bits(3, 14, 2), later);
  EXPECT_NE(NoiseStreams(8).bits(3, 14, 2), later);
}

TEST(NoiseStreams, NoTwoAddressesShareTheirNoise) {
  const NoiseStreams noise(1);
  std::set<std::uint64_t> seen;
  for (int scenario = 0; scenario < 100; ++scenario) {
    for (int depth = 0; depth <= 100; ++depth) {
      for (int index = 0; index < 8; ++index) seen.insert(noise.bits(scenario, depth, index));
    }
  }
  EXPECT_EQ(seen.size(), 100U * 101U * 8U);
}

TEST(NoiseStreams, IsUniformInTheUnitInterval) {
  const NoiseStreams noise(42);
  constexpr int kBins = 50;
  constexpr int kDraws = 100 * 100 * 10;
  std::array<int, kBins> bins{};
  for (int scenario = 0; scenario < 100; ++scenario) {
    for (int depth = 0; depth < 100; ++depth) {
      for (int index = 0; index < 10; ++index) {
        const double u = noise.uniform(scenario, depth, index);
        ASSERT_GE(u, 0.0);
        ASSERT_LT(u, 1.0);
        ++bins[static_cast<size_t>(u * kBins)];
      }
    }
  }
  const double expected = static_cast<double>(kDraws) / kBins;
  double chi_squared = 0.0;
  for (int count : bins) chi_squared += (count - expected) * (count - expected) / expected;
  // 49 degrees of freedom: above 100 with probability 2e-5, below 15 with 1e-6.
  EXPECT_LT(chi_squared, 100.0);
  EXPECT_GT(chi_squared, 15.0);
}

// Neighbours in any coordinate, and the same address under neighbouring seeds.
TEST(NoiseStreams, NeighboursAreUncorrelated) {
  const auto correlation = [](int scenario_step, int depth_step, int index_step, int seed_step) {
    const NoiseStreams noise(5);
    const NoiseStreams other(5 + static_cast<std::uint64_t>(seed_step));
    double sum = 0.0;
    int count = 0;
    for (int k = 0; k < 40; ++k) {
      for (int d = 0; d < 50; ++d) {
        for (int i = 0; i < 10; ++i, ++count) {
          sum += (noise.uniform(k, d, i) - 0.5) *
                 (other.uniform(k + scenario_step, d + depth_step, i + index_step) - 0.5);
        }
      }
    }
    return 12.0 * sum / count;
  };
  constexpr double kFourSigma = 4.0 / 141.0;  // 20000 pairs
  EXPECT_NEAR(correlation(0, 0, 0, 0), 1.0, 0.03);
  EXPECT_NEAR(correlation(1, 0, 0, 0), 0.0, kFourSigma);
  EXPECT_NEAR(correlation(0, 1, 0, 0), 0.0, kFourSigma);
  EXPECT_NEAR(correlation(0, 0, 1, 0), 0.0, kFourSigma);
  EXPECT_NEAR(correlation(0, 0, 0, 1), 0.0, kFourSigma);
}

}  // namespace
}  // namespace pomdp_crowd_nav
