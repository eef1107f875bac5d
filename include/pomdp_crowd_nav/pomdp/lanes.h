// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

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

PCN_INLINE float squareRoot(float x) { return std::sqrt(x); }
PCN_INLINE Lanes squareRoot(const Lanes& x) {
  Lanes root;
  for (int i = 0; i < kLanes; ++i) root[i] = __builtin_sqrtf(x[i]);
  return root;
}

PCN_INLINE bool anyOf(bool mask) { return mask; }
PCN_INLINE bool anyOf(const LaneMask& mask) {
  int any = 0;
  for (int i = 0; i < kLanes; ++i) any |= mask[i];
  return any != 0;
}

PCN_INLINE int countOf(bool mask) { return mask ? 1 : 0; }
PCN_INLINE int countOf(const LaneMask& mask) {
  int count = 0;
  for (int i = 0; i < kLanes; ++i) count -= mask[i];
  return count;
}

// The same value in every lane.
template <class Value>
PCN_INLINE Value spread(float value) {
  return Value{} + value;
}

// The mask type that belongs to a value type.
template <class Value>
struct MaskOf {
  using Type = LaneMask;
};
template <>
struct MaskOf<float> {
  using Type = bool;
};

}  // namespace pomdp_crowd_nav
