// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Eight lanes of AVX2; what the functions mean: portable_lanes.h.
#pragma once

#include <immintrin.h>

#include <cstddef>

namespace primitect::kernels {
namespace {

constexpr int kLanes = 8;
using Floats = float __attribute__((vector_size(4 * kLanes)));
using Ints = int __attribute__((vector_size(4 * kLanes)));

inline Floats load(const float* values) { return (Floats)_mm256_loadu_ps(values); }
inline Ints loadInts(const int* values) { return (Ints)_mm256_loadu_si256(reinterpret_cast<const __m256i*>(values)); }
inline void store(Ints lanes, int* values) { _mm256_storeu_si256(reinterpret_cast<__m256i*>(values), (__m256i)lanes); }
inline void store(Floats lanes, float* values) { _mm256_storeu_ps(values, (__m256)lanes); }

inline Floats squareRoot(Floats v) { return (Floats)_mm256_sqrt_ps((__m256)v); }
inline Floats larger(Floats a, Floats b) { return (Floats)_mm256_max_ps((__m256)a, (__m256)b); }
inline Floats smaller(Floats a, Floats b) { return (Floats)_mm256_min_ps((__m256)a, (__m256)b); }
inline Floats absolute(Floats v) { return (Floats)((Ints)v & 0x7fffffff); }

/// A product that is not to be fused with a sum.
inline Floats rounded(Floats product) {
  __asm__("" : "+x"(product));
  return product;
}

inline Ints gather(const int* table, Ints index) { return (Ints)_mm256_i32gather_epi32(table, (__m256i)index, 4); }

inline int bitsOf(Ints mask) { return _mm256_movemask_ps((__m256)mask); }
inline bool any(Ints mask) { return bitsOf(mask) != 0; }

/// Rows of four, one for each lane.
inline void storeRows(const Floats (&columns)[4], float* rows) {
  const __m256 ab_low = _mm256_unpacklo_ps((__m256)columns[0], (__m256)columns[1]);
  const __m256 ab_high = _mm256_unpackhi_ps((__m256)columns[0], (__m256)columns[1]);
  const __m256 cd_low = _mm256_unpacklo_ps((__m256)columns[2], (__m256)columns[3]);
  const __m256 cd_high = _mm256_unpackhi_ps((__m256)columns[2], (__m256)columns[3]);
  const __m256 rows_of_half[4] = {_mm256_shuffle_ps(ab_low, cd_low, 0x44), _mm256_shuffle_ps(ab_low, cd_low, 0xee),
                                  _mm256_shuffle_ps(ab_high, cd_high, 0x44), _mm256_shuffle_ps(ab_high, cd_high, 0xee)};
  for (int k = 0; k < 4; ++k) {
    _mm_storeu_ps(rows + 4 * k, _mm256_castps256_ps128(rows_of_half[k]));
    _mm_storeu_ps(rows + 4 * (k + 4), _mm256_extractf128_ps(rows_of_half[k], 1));
  }
}

/// For each of the 256 masks the lanes that it selects, in order, a byte each.
struct PackingTable {
  alignas(64) unsigned char lane[256][8];
  constexpr PackingTable() : lane() {
    for (int mask = 0; mask < 256; ++mask) {
      int count = 0;
      for (int k = 0; k < 8; ++k) {
        if (mask >> k & 1) lane[mask][count++] = static_cast<unsigned char>(k);
      }
    }
  }
};
constexpr PackingTable kPackingTable;

class Packing {
 public:
  explicit Packing(Ints mask) {
    const int bits = bitsOf(mask);
    count_ = __builtin_popcount(static_cast<unsigned>(bits));
    lanes_ = _mm256_cvtepu8_epi32(_mm_loadl_epi64(reinterpret_cast<const __m128i*>(kPackingTable.lane[bits])));
  }
  int count() const { return count_; }
  /// Lanes from count() on mean nothing.
  Floats packed(Floats lanes) const { return (Floats)_mm256_permutevar8x32_ps((__m256)lanes, lanes_); }
  Ints packed(Ints lanes) const { return (Ints)_mm256_permutevar8x32_epi32((__m256i)lanes, lanes_); }

 private:
  __m256i lanes_;
  int count_;
};

}  // namespace
}  // namespace primitect::kernels
