// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Sixteen lanes of AVX-512; what the functions mean: portable_lanes.h.
#pragma once

#include <immintrin.h>

#include <cstddef>

namespace primitect::kernels {
namespace {

constexpr int kLanes = 16;
using Floats = float __attribute__((vector_size(4 * kLanes)));
using Ints = int __attribute__((vector_size(4 * kLanes)));

inline Floats load(const float* values) { return (Floats)_mm512_loadu_ps(values); }
inline Ints loadInts(const int* values) { return (Ints)_mm512_loadu_si512(values); }
inline void store(Ints lanes, int* values) { _mm512_storeu_si512(values, (__m512i)lanes); }
inline void store(Floats lanes, float* values) { _mm512_storeu_ps(values, (__m512)lanes); }

inline Floats squareRoot(Floats v) { return (Floats)_mm512_sqrt_ps((__m512)v); }
inline Floats larger(Floats a, Floats b) { return (Floats)_mm512_max_ps((__m512)a, (__m512)b); }
inline Floats smaller(Floats a, Floats b) { return (Floats)_mm512_min_ps((__m512)a, (__m512)b); }
inline Floats absolute(Floats v) { return (Floats)((Ints)v & 0x7fffffff); }

/// A product that is not to be fused with a sum.
inline Floats rounded(Floats product) {
  __asm__("" : "+v"(product));
  return product;
}

inline Ints gather(const int* table, Ints index) { return (Ints)_mm512_i32gather_epi32((__m512i)index, table, 4); }

inline __mmask16 bitsOf(Ints mask) { return _mm512_movepi32_mask((__m512i)mask); }
inline bool any(Ints mask) { return bitsOf(mask) != 0; }

/// Rows of four, one for each lane.
inline void storeRows(const Floats (&columns)[4], float* rows) {
  const __m512 ab_low = _mm512_unpacklo_ps((__m512)columns[0], (__m512)columns[1]);
  const __m512 ab_high = _mm512_unpackhi_ps((__m512)columns[0], (__m512)columns[1]);
  const __m512 cd_low = _mm512_unpacklo_ps((__m512)columns[2], (__m512)columns[3]);
  const __m512 cd_high = _mm512_unpackhi_ps((__m512)columns[2], (__m512)columns[3]);
  // Of each quarter of the lanes the first row, the second, ...
  const __m512 row[4] = {_mm512_shuffle_ps(ab_low, cd_low, 0x44), _mm512_shuffle_ps(ab_low, cd_low, 0xee),
                         _mm512_shuffle_ps(ab_high, cd_high, 0x44), _mm512_shuffle_ps(ab_high, cd_high, 0xee)};
  const __m512 first_low = _mm512_shuffle_f32x4(row[0], row[1], 0x44),
               second_low = _mm512_shuffle_f32x4(row[2], row[3], 0x44);
  const __m512 first_high = _mm512_shuffle_f32x4(row[0], row[1], 0xee),
               second_high = _mm512_shuffle_f32x4(row[2], row[3], 0xee);
  _mm512_storeu_ps(rows, _mm512_shuffle_f32x4(first_low, second_low, 0x88));
  _mm512_storeu_ps(rows + 16, _mm512_shuffle_f32x4(first_low, second_low, 0xdd));
  _mm512_storeu_ps(rows + 32, _mm512_shuffle_f32x4(first_high, second_high, 0x88));
  _mm512_storeu_ps(rows + 48, _mm512_shuffle_f32x4(first_high, second_high, 0xdd));
}

class Packing {
 public:
  explicit Packing(Ints mask) : bits_(bitsOf(mask)) {}
  int count() const { return __builtin_popcount(bits_); }
  /// Lanes from count() on mean nothing.
  Floats packed(Floats lanes) const { return (Floats)_mm512_maskz_compress_ps(bits_, (__m512)lanes); }
  Ints packed(Ints lanes) const { return (Ints)_mm512_maskz_compress_epi32(bits_, (__m512i)lanes); }

 private:
  __mmask16 bits_;
};

}  // namespace
}  // namespace primitect::kernels
