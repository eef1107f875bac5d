// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Several floats that are computed with at once, as the compiler's own vector types. Each kernel
// uses the one that fills a register of its instruction set; a wider one would be taken apart lane
// by lane. Every function works on a single float too, so that the same formula runs vectorised in
// the search and one by one in its test.
namespace pomdp_crowd_nav {

#define PCN_INLINE inline __attribute__((always_inline))

using Float4 = float __attribute__((vector_size(16)));   // SSE, NEON
using Float8 = float __attribute__((vector_size(32)));   // AVX
using Float16 = float __attribute__((vector_size(64)));  // AVX-512
using Mask4 = int __attribute__((vector_size(16)));      // -1 true, 0 false
using Mask8 = int __attribute__((vector_size(32)));
using Mask16 = int __attribute__((vector_size(64)));

// The mask of a value type.
template <class Value>
struct MaskOf;
template <>
struct MaskOf<float> {
  using Type = bool;
};
template <>
struct MaskOf<Float4> {
  using Type = Mask4;
};
template <>
struct MaskOf<Float8> {
  using Type = Mask8;
};
template <>
struct MaskOf<Float16> {
  using Type = Mask16;
};

template <class Value>
constexpr int kLanesOf = sizeof(Value) / sizeof(float);

template <class Value>
PCN_INLINE Value select(const typename MaskOf<Value>::Type& mask, const Value& yes,
                        const Value& no) {
  return mask ? yes : no;
}

template <class Value>
PCN_INLINE Value smaller(const Value& a, const Value& b) {
  return a < b ? a : b;
}

template <class Value>
PCN_INLINE Value larger(const Value& a, const Value& b) {
  return a > b ? a : b;
}

// The same value in every lane.
template <class Value>
PCN_INLINE Value spread(float value) {
  return Value{} + value;
}

template <class Value>
PCN_INLINE Value load(const float* lanes) {
  Value value;
  __builtin_memcpy(&value, lanes, sizeof(Value));
  return value;
}
template <class Mask>
PCN_INLINE Mask loadMask(const int* lanes) {
  Mask mask;
  __builtin_memcpy(&mask, lanes, sizeof(Mask));
  return mask;
}
// Values and masks alike.
template <class Lanes, class Scalar>
PCN_INLINE void store(const Lanes& lanes, Scalar* to) {
  static_assert(sizeof(Scalar) == 4, "one word a lane");
  __builtin_memcpy(to, &lanes, sizeof(Lanes));
}

PCN_INLINE float squareRoot(float x) { return __builtin_sqrtf(x); }
template <class Value>
PCN_INLINE Value squareRoot(const Value& x) {
  float roots[kLanesOf<Value>];
  store(x, roots);
  for (float& root : roots) root = __builtin_sqrtf(root);
  return load<Value>(roots);
}

PCN_INLINE bool anyOf(bool mask) { return mask; }
PCN_INLINE bool anyOf(const Mask4& mask) {
  using Halves = long long __attribute__((vector_size(16)));
  const Halves halves = reinterpret_cast<Halves>(mask);
  return (halves[0] | halves[1]) != 0;
}
PCN_INLINE bool anyOf(const Mask8& mask) {
  Mask4 halves[2];
  __builtin_memcpy(halves, &mask, sizeof(halves));
  return anyOf(halves[0] | halves[1]);
}
PCN_INLINE bool anyOf(const Mask16& mask) {
  Mask8 halves[2];
  __builtin_memcpy(halves, &mask, sizeof(halves));
  return anyOf(halves[0] | halves[1]);
}

// Counts true lanes over many masks.
template <class Mask>
struct TrueCount {
  Mask counts{};
  PCN_INLINE void add(const Mask& mask) { counts -= mask; }
  PCN_INLINE long total() const {
    long sum = 0;
    for (unsigned i = 0; i < sizeof(Mask) / sizeof(int); ++i) sum += counts[i];
    return sum;
  }
};
template <>
struct TrueCount<bool> {
  long count = 0;
  PCN_INLINE void add(bool mask) { count += mask ? 1 : 0; }
  PCN_INLINE long total() const { return count; }
};

}  // namespace pomdp_crowd_nav
