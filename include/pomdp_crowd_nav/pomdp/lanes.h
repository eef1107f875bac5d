// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#if defined(PCN_HAS_AVX2) || defined(PCN_HAS_AVX512)
#include <immintrin.h>
#endif

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
template <>
PCN_INLINE bool loadMask<bool>(const int* lanes) {
  return *lanes != 0;
}
// Values and masks alike.
template <class Lanes, class Scalar>
PCN_INLINE void store(const Lanes& lanes, Scalar* to) {
  static_assert(sizeof(Scalar) == 4, "one word a lane");
  __builtin_memcpy(to, &lanes, sizeof(Lanes));
}
PCN_INLINE void store(bool mask, int* to) { *to = mask ? -1 : 0; }

// What a table of words says at each lane's index. Compilers make poor code of the loop where the
// machine has an instruction for it.
template <class Mask>
PCN_INLINE Mask gather(const std::int32_t* table, const Mask& indices) {
  constexpr int kCount = sizeof(Mask) / sizeof(int);
  int words[kCount];
  store(indices, words);
  for (int& word : words) word = table[word];
  return loadMask<Mask>(words);
}
#ifdef PCN_HAS_AVX2
PCN_INLINE Mask8 gather(const std::int32_t* table, const Mask8& indices) {
  return reinterpret_cast<Mask8>(
      _mm256_i32gather_epi32(table, reinterpret_cast<__m256i>(indices), 4));
}
#endif
#ifdef PCN_HAS_AVX512
PCN_INLINE Mask16 gather(const std::int32_t* table, const Mask16& indices) {
  // The unmasked form trips the compiler's own warnings.
  return reinterpret_cast<Mask16>(_mm512_mask_i32gather_epi32(
      _mm512_setzero_si512(), 0xFFFF, reinterpret_cast<__m512i>(indices), table, 4));
}
#endif
template <class Value>
PCN_INLINE Value gather(const float* table, const typename MaskOf<Value>::Type& indices) {
  int at[kLanesOf<Value>];
  store(indices, at);
  float values[kLanesOf<Value>];
  for (int i = 0; i < kLanesOf<Value>; ++i) values[i] = table[at[i]];
  return load<Value>(values);
}

// The smallest of all lanes.
PCN_INLINE float smallestOf(float value) { return value; }
PCN_INLINE float smallestOf(const Float4& value) {
  const float a = value[0] < value[1] ? value[0] : value[1];
  const float b = value[2] < value[3] ? value[2] : value[3];
  return a < b ? a : b;
}
template <class Half, class Value>
PCN_INLINE Half smallerHalf(const Value& value) {
  Half halves[2];
  __builtin_memcpy(halves, &value, sizeof(halves));
  return smaller(halves[0], halves[1]);
}
PCN_INLINE float smallestOf(const Float8& value) { return smallestOf(smallerHalf<Float4>(value)); }
PCN_INLINE float smallestOf(const Float16& value) { return smallestOf(smallerHalf<Float8>(value)); }

PCN_INLINE float squareRoot(float x) { return __builtin_sqrtf(x); }
template <class Value>
PCN_INLINE Value squareRoot(const Value& x) {
  float roots[kLanesOf<Value>];
  store(x, roots);
  for (float& root : roots) root = __builtin_sqrtf(root);
  return load<Value>(roots);
}

// Polynomial in `u` by Horner's rule, coefficients from the lowest power on.
template <class Value, int kCount>
PCN_INLINE Value polynomial(const float (&coefficients)[kCount], const Value& u) {
  Value sum = spread<Value>(coefficients[kCount - 1]);
  for (int i = kCount - 2; i >= 0; --i) sum = sum * u + coefficients[i];
  return sum;
}

// Of a value in [-1, 1], to 2e-7: interpolates arctan(x) / x in x^2 at the Chebyshev nodes.
template <class Value>
PCN_INLINE Value arcTangent(const Value& x) {
  constexpr float kCoefficients[] = {0.999999882F,  -0.333318127F,  0.199669618F,  -0.140032902F,
                                     0.0986886546F, -0.0588297531F, 0.0237805186F, -0.00455979199F};
  return x * polynomial<Value>(kCoefficients, x * x);
}

// Of an angle in [-pi / 4, pi / 4], to 1e-7; Taylor series.
template <class Value>
PCN_INLINE Value cosineOf(const Value& angle) {
  constexpr float kCoefficients[] = {1.0F, -1.0F / 2.0F, 1.0F / 24.0F, -1.0F / 720.0F,
                                     1.0F / 40320.0F};
  return polynomial<Value>(kCoefficients, angle * angle);
}

// sin(angle) / angle, for the same angles.
template <class Value>
PCN_INLINE Value sineOver(const Value& angle) {
  constexpr float kCoefficients[] = {1.0F, -1.0F / 6.0F, 1.0F / 120.0F, -1.0F / 5040.0F,
                                     1.0F / 362880.0F};
  return polynomial<Value>(kCoefficients, angle * angle);
}

// How many lanes are true.
PCN_INLINE int countOf(bool mask) { return mask ? 1 : 0; }
PCN_INLINE int countOf(const Mask4& mask) { return -(mask[0] + mask[1] + mask[2] + mask[3]); }
PCN_INLINE int countOf(const Mask8& mask) {
  Mask4 halves[2];
  __builtin_memcpy(halves, &mask, sizeof(halves));
  return countOf(halves[0] + halves[1]);
}
PCN_INLINE int countOf(const Mask16& mask) {
  Mask8 halves[2];
  __builtin_memcpy(halves, &mask, sizeof(halves));
  return countOf(halves[0] + halves[1]);
}

}  // namespace pomdp_crowd_nav
