// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Four lanes in the compiler's own vector type: SSE2 on any x86-64, NEON on Arm, plain code elsewhere.
//
// A kernel file includes one such header of lanes, then vector_votes.h, which is written in terms of them. All of it
// lies in an anonymous namespace: code compiled for one processor must not be linked into that of another.
#pragma once

#include <cstddef>

namespace primitect::kernels {
namespace {

constexpr int kLanes = 4;
using Floats = float __attribute__((vector_size(4 * kLanes)));
using Ints = int __attribute__((vector_size(4 * kLanes)));  // a mask where a comparison gave it: all bits or none

inline Floats load(const float* values) {
  Floats lanes;
  __builtin_memcpy(&lanes, values, sizeof lanes);
  return lanes;
}

inline Ints loadInts(const int* values) {
  Ints lanes;
  __builtin_memcpy(&lanes, values, sizeof lanes);
  return lanes;
}

inline void store(Ints lanes, int* values) { __builtin_memcpy(values, &lanes, sizeof lanes); }
inline void store(Floats lanes, float* values) { __builtin_memcpy(values, &lanes, sizeof lanes); }

inline Floats squareRoot(Floats v) {
  for (int k = 0; k < kLanes; ++k) v[k] = __builtin_sqrtf(v[k]);
  return v;
}

/// The second one where either is NaN.
inline Floats larger(Floats a, Floats b) { return a > b ? a : b; }
inline Floats smaller(Floats a, Floats b) { return a < b ? a : b; }

inline Floats absolute(Floats v) { return (Floats)((Ints)v & 0x7fffffff); }

/// A product that is not to be fused with a sum. Nothing is fused in files compiled with the common flags.
inline Floats rounded(Floats product) { return product; }

inline Ints gather(const int* table, Ints index) {
  for (int k = 0; k < kLanes; ++k) index[k] = table[index[k]];
  return index;
}

inline bool any(Ints mask) { return (mask[0] | mask[1] | mask[2] | mask[3]) != 0; }

/// Rows of four, one for each lane.
inline void storeRows(const Floats (&columns)[4], float* rows) {
  for (int k = 0; k < kLanes; ++k)
    store(Floats{columns[0][k], columns[1][k], columns[2][k], columns[3][k]}, rows + 4 * k);
}

/// Moves the lanes of a mask to the front.
class Packing {
 public:
  explicit Packing(Ints mask) {
    for (int k = 0; k < kLanes; ++k) {
      lane_[count_] = k;
      count_ -= mask[k];
    }
  }
  int count() const { return count_; }

  /// Lanes from count() on mean nothing.
  Floats packed(Floats lanes) const {
    return Floats{lanes[lane_[0]], lanes[lane_[1]], lanes[lane_[2]], lanes[lane_[3]]};
  }
  Ints packed(Ints lanes) const { return Ints{lanes[lane_[0]], lanes[lane_[1]], lanes[lane_[2]], lanes[lane_[3]]}; }

 private:
  int lane_[kLanes + 1] = {};
  int count_ = 0;
};

}  // namespace
}  // namespace primitect::kernels
