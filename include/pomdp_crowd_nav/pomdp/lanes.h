// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pomdp_crowd_nav/pomdp/action.h"

// Sixteen floats that are computed with at once, as the compiler's own vector type: it becomes one
// AVX-512, two AVX or four SSE/NEON registers. Every function has a twin on one float, so that
// the same formula runs vectorised in the search and one by one in its test.
namespace pomdp_crowd_nav {

constexpr int kLanes = kMaxActions;

using Lanes = float __attribute__((vector_size(kLanes * sizeof(float))));
using LaneMask = int __attribute__((vector_size(kLanes * sizeof(int))));  // -1 true, 0 false

#define PCN_INLINE inline __attribute__((always_inline))

PCN_INLINE float select(bool mask, float yes, float no) { return mask ? yes : no; }
PCN_INLINE Lanes select(const LaneMask& mask, const Lanes& yes, const Lanes& no) {
  return mask ? yes : no;
}

template <class Value>
PCN_INLINE Value smaller(const Value& a, const Value& b) {
  return select(a < b, a, b);
}

template <class Value>
PCN_INLINE Value larger(const Value& a, const Value& b) {
  return select(a > b, a, b);
}

PCN_INLINE float squareRoot(float x) { return __builtin_sqrtf(x); }
PCN_INLINE Lanes squareRoot(const Lanes& x) {
  float roots[kLanes];
  __builtin_memcpy(roots, &x, sizeof(roots));
  for (float& root : roots) root = __builtin_sqrtf(root);
  Lanes out;
  __builtin_memcpy(&out, roots, sizeof(roots));
  return out;
}

PCN_INLINE bool anyOf(bool mask) { return mask; }
PCN_INLINE bool anyOf(const LaneMask& mask) {
  using Half = int __attribute__((vector_size(32)));
  using Quarter = long long __attribute__((vector_size(16)));
  Half halves[2];
  __builtin_memcpy(halves, &mask, sizeof(halves));
  const Half both = halves[0] | halves[1];
  Quarter quarters[2];
  __builtin_memcpy(quarters, &both, sizeof(quarters));
  const Quarter all = quarters[0] | quarters[1];
  return (all[0] | all[1]) != 0;
}

// Counts true lanes over many masks.
struct FlagCount {
  long count = 0;
  void add(bool mask) { count += mask ? 1 : 0; }
  long total() const { return count; }
};
struct LaneCount {
  LaneMask counts{};
  PCN_INLINE void add(const LaneMask& mask) { counts -= mask; }
  PCN_INLINE long total() const {
    long sum = 0;
    for (int i = 0; i < kLanes; ++i) sum += counts[i];
    return sum;
  }
};

// The same value in every lane.
template <class Value>
PCN_INLINE Value spread(float value) {
  return Value{} + value;
}

// The mask of a value type, and what counts its true lanes.
template <class Value>
struct MaskOf {
  using Type = LaneMask;
  using Count = LaneCount;
};
template <>
struct MaskOf<float> {
  using Type = bool;
  using Count = FlagCount;
};

}  // namespace pomdp_crowd_nav
