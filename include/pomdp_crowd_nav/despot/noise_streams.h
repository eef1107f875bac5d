// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace pomdp_crowd_nav {

// Random numbers addressed by (scenario, depth, index), so that a scenario meets the same noise
// whatever is searched, and in whatever order (Ye et al. 2017, section 3: a scenario is a start
// state and an infinite sequence of noise). Holds the seed and nothing else.
class NoiseStreams {
 public:
  explicit NoiseStreams(std::uint64_t seed) : seed_(mix(seed + 0x9E3779B97F4A7C15ULL)) {}

  // 64 random bits.
  std::uint64_t bits(int scenario, int depth, int index) const {
    const std::uint64_t address = (static_cast<std::uint64_t>(scenario) << 40) ^
                                  (static_cast<std::uint64_t>(depth) << 20) ^
                                  static_cast<std::uint64_t>(index);
    return mix(seed_ + address * 0x9E3779B97F4A7C15ULL);
  }

  // Uniform in [0, 1).
  double uniform(int scenario, int depth, int index) const {
    return static_cast<double>(bits(scenario, depth, index) >> 11) * 0x1.0p-53;
  }

 private:
  // Finaliser of SplitMix64 (Steele, Lea, Flood 2014).
  static std::uint64_t mix(std::uint64_t z) {
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ULL;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBULL;
    return z ^ (z >> 31);
  }

  std::uint64_t seed_;
};

}  // namespace pomdp_crowd_nav
