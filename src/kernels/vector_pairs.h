// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Which pairs of a reference vote, kLanes at a time, for a kernel file that has included its lanes. What passes the
// conditions is packed into lists that stay in the first cache, so that later steps have all lanes full.
#pragma once

#include "kernels/kernels.h"

namespace primitect::kernels {
namespace {

/// Pairs that a list takes before it must be emptied.
constexpr int kPairs = 128;
constexpr int kRoom = kPairs + 2 * kLanes;

/// kLanes pairs: eq. 2, and what shapes with an axis need besides.
struct PairLanes {
  Floats c1, c2, c3, c4;
  Floats dx, dy, dz, nx, ny, nz;
};

/// 0, 1, 2, ...
Ints laneNumbers() {
  Ints lanes;
  for (int k = 0; k < kLanes; ++k) lanes[k] = k;
  return lanes;
}

Ints all(bool fact) { return Ints{} - static_cast<int>(fact); }

class PairList {
 public:
  bool full() const { return count_ > kPairs - kBoxSamples; }
  int count() const { return count_; }

  void appendFeatures(const PairLanes& pair, const Packing& packing) {
    const Floats features[] = {pair.c1, pair.c2, pair.c3, pair.c4};
    for (int k = 0; k < 4; ++k) store(packing.packed(features[k]), values_[k] + count_);
    count_ += packing.count();
  }
  void append(const PairLanes& pair, const Packing& packing) {
    const Floats rest[] = {pair.dx, pair.dy, pair.dz, pair.nx, pair.ny, pair.nz};
    for (int k = 0; k < 6; ++k) store(packing.packed(rest[k]), values_[4 + k] + count_);
    appendFeatures(pair, packing);
  }

  /// The lanes beyond the last pair become pairs of zeros.
  void pad() {
    for (auto& values : values_) store(Floats{}, values + count_);
  }
  PairLanes at(int i) const {
    const auto v = [&](int k) { return load(values_[k] + i); };
    return {v(0), v(1), v(2), v(3), v(4), v(5), v(6), v(7), v(8), v(9)};
  }
  /// The lanes of at(i) that are pairs of the list.
  Ints valid(int i) const { return laneNumbers() < count_ - i; }
  void clear() { count_ = 0; }

 private:
  int count_ = 0;
  alignas(64) float values_[10][kRoom];
};

/// Pairs by what they vote for.
struct SelectedPairs {
  PairList plane, convex, concave;

  bool full() const { return plane.full() || convex.full() || concave.full(); }
};

/// In the innermost loop, where a call would cost more than the work.
#define PRIMITECT_INLINE inline __attribute__((always_inline))

/// What the samples are compared with, in all lanes. A copy, which the compiler can keep in registers.
struct Comparison {
  Comparison(const OrientedPoint& r, const VotingRules& rules)
      : x(Floats{} + r.point.x),
        y(Floats{} + r.point.y),
        z(Floats{} + r.point.z),
        nx(Floats{} + r.normal.x),
        ny(Floats{} + r.normal.y),
        nz(Floats{} + r.normal.z),
        max_distance_sq(Floats{} + rules.max_distance_sq),
        cos_epsilon(Floats{} + rules.cos_epsilon),
        sin_epsilon_sq(Floats{} + rules.sin_epsilon_sq),
        planes(all(rules.planes)),
        any_plane(all(rules.planes && !rules.convex_planes)) {}

  Floats x, y, z, nx, ny, nz;
  Floats max_distance_sq, cos_epsilon, sin_epsilon_sq;
  Ints planes, any_plane;  ///< whether pairs on a voting side, and all pairs, vote for planes
};

/// As scalar.cpp rounds it: the features of a pair are the same, bit for bit, in all kernels. On an exact plane C2 and
/// C3 are 0 but for rounding, and nothing else decides which side a pair is seen from.
PRIMITECT_INLINE Floats dot(Floats ax, Floats ay, Floats az, Floats bx, Floats by, Floats bz) {
  return rounded(ax * bx) + rounded(ay * by) + rounded(az * bz);
}

template <bool kAppend>
PRIMITECT_INLINE void append(const PairLanes& pair, Ints mask, PairList& list) {
  if (kAppend && any(mask)) list.append(pair, Packing(mask));
}

/// Conditions of algorithm 1 for the pairs with samples i, i + 1, ...
template <bool kConvex, bool kConcave>
PRIMITECT_INLINE void select(const Comparison& r, const Samples& s, std::size_t i, SelectedPairs& selected) {
  PairLanes p;
  p.dx = load(s.x + i) - r.x;
  p.dy = load(s.y + i) - r.y;
  p.dz = load(s.z + i) - r.z;
  p.nx = load(s.nx + i);
  p.ny = load(s.ny + i);
  p.nz = load(s.nz + i);
  p.c1 = dot(p.dx, p.dy, p.dz, p.dx, p.dy, p.dz);
  p.c2 = dot(p.dx, p.dy, p.dz, r.nx, r.ny, r.nz);
  p.c3 = dot(p.dx, p.dy, p.dz, p.nx, p.ny, p.nz);
  p.c4 = dot(p.nx, p.ny, p.nz, r.nx, r.ny, r.nz);
  const Ints near = (p.c1 > 0.0f) & (p.c1 <= r.max_distance_sq);
  const Ints convex = kConvex ? near & (p.c2 <= 0.0f) & (p.c3 >= 0.0f) : Ints{};
  const Ints concave = kConcave ? near & ~convex & (p.c2 >= 0.0f) & (p.c3 <= 0.0f) : Ints{};
  const Ints parallel = p.c4 > r.cos_epsilon;
  const Floats coplanar_sq = r.sin_epsilon_sq * p.c1;
  const Ints coplanar = (p.c2 * p.c2 < coplanar_sq) & (p.c3 * p.c3 < coplanar_sq);
  const Ints plane = (((convex | concave) & r.planes) | (near & r.any_plane)) & parallel & coplanar;
  if (any(plane)) selected.plane.appendFeatures(p, Packing(plane));
  append<kConvex>(p, convex & ~parallel, selected.convex);
  append<kConcave>(p, concave & ~parallel, selected.concave);
}

/// The last samples, fewer than a box holds, with NaN for the missing ones.
template <bool kConvex, bool kConcave>
void selectRest(const Comparison& reference, const Samples& s, std::size_t begin, SelectedPairs& selected) {
  const float* const values[6] = {s.x, s.y, s.z, s.nx, s.ny, s.nz};
  float rest[6][kBoxSamples];
  for (int k = 0; k < 6; ++k) {
    for (int j = 0; j < kBoxSamples; ++j) {
      rest[k][j] = begin + j < s.count ? values[k][begin + j] : __builtin_nanf("");
    }
  }
  const Samples padded = {rest[0], rest[1], rest[2], rest[3], rest[4], rest[5], kBoxSamples};
  for (int i = 0; i < kBoxSamples; i += kLanes) select<kConvex, kConcave>(reference, padded, i, selected);
}

/// The samples of box k, as Samples::boxes numbers them.
template <bool kConvex, bool kConcave>
PRIMITECT_INLINE void selectBox(const Comparison& reference, const Samples& samples, std::size_t k,
                                SelectedPairs& selected) {
  const std::size_t begin = k * kBoxSamples;
  if (begin + kBoxSamples > samples.count) return selectRest<kConvex, kConcave>(reference, samples, begin, selected);
  for (int i = 0; i < kBoxSamples; i += kLanes) select<kConvex, kConcave>(reference, samples, begin + i, selected);
}

/// Which of kLanes boxes from the k-th on may hold a sample near enough.
Ints nearBoxes(const Comparison& r, const Boxes& b, std::size_t k) {
  // Rounding keeps order, so that no sample is nearer than its box says: boxes and pairs are rounded alike.
  const auto outside = [](Floats low, Floats high, Floats v) { return larger(Floats{}, larger(low - v, v - high)); };
  const Floats x = outside(load(b.min_x + k), load(b.max_x + k), r.x);
  const Floats y = outside(load(b.min_y + k), load(b.max_y + k), r.y);
  const Floats z = outside(load(b.min_z + k), load(b.max_z + k), r.z);
  return dot(x, y, z, x, y, z) <= r.max_distance_sq;
}

}  // namespace
}  // namespace primitect::kernels
