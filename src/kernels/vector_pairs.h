// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Which pairs of a reference vote, and for what, kLanes at a time; for a kernel file that has included its lanes.
#pragma once

#include "kernels/kernels.h"
#include "kernels/vector_lists.h"

namespace primitect::kernels {
namespace {

/// Fields of pairs that vote for planes: eq. 2. Of the others, d and the normal, from which these follow: packing four
/// more fields takes longer than to find them anew where all lanes are full.
enum PairFeature { kC1, kC2, kC3, kC4 };
enum PairField { kDx, kDy, kDz, kNx, kNy, kNz };

/// Pairs by what they vote for.
struct SelectedPairs {
  LaneList<4> plane;
  LaneList<6> convex, concave;

  bool full() const {
    constexpr int kMost = kEntries - kBoxSamples;
    return plane.count() > kMost || convex.count() > kMost || concave.count() > kMost;
  }
};

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

struct FeatureLanes {
  Floats c1, c2, c3, c4;
};

/// Eq. 2.
PRIMITECT_INLINE FeatureLanes features(Floats rx, Floats ry, Floats rz, Floats dx, Floats dy, Floats dz, Floats nx,
                                       Floats ny, Floats nz) {
  return {dot(dx, dy, dz, dx, dy, dz), dot(dx, dy, dz, rx, ry, rz), dot(dx, dy, dz, nx, ny, nz),
          dot(nx, ny, nz, rx, ry, rz)};
}

/// Conditions of algorithm 1 for the pairs with samples i, i + 1, ...
template <bool kConvex, bool kConcave>
PRIMITECT_INLINE void select(const Comparison& r, const Samples& s, std::size_t i, SelectedPairs& selected) {
  const Floats dx = load(s.x + i) - r.x, dy = load(s.y + i) - r.y, dz = load(s.z + i) - r.z;
  const Floats nx = load(s.nx + i), ny = load(s.ny + i), nz = load(s.nz + i);
  const auto [c1, c2, c3, c4] = features(r.nx, r.ny, r.nz, dx, dy, dz, nx, ny, nz);
  const Ints near = (c1 > 0.0f) & (c1 <= r.max_distance_sq);
  const Ints convex = kConvex ? near & (c2 <= 0.0f) & (c3 >= 0.0f) : Ints{};
  const Ints concave = kConcave ? near & ~convex & (c2 >= 0.0f) & (c3 <= 0.0f) : Ints{};
  const Ints parallel = c4 > r.cos_epsilon;
  const Floats coplanar_sq = r.sin_epsilon_sq * c1;
  const Ints coplanar = (c2 * c2 < coplanar_sq) & (c3 * c3 < coplanar_sq);
  const Ints plane = (((convex | concave) & r.planes) | (near & r.any_plane)) & parallel & coplanar;
  if (any(plane)) selected.plane.append({c1, c2, c3, c4}, Packing(plane));
  const Ints convex_curved = convex & ~parallel, concave_curved = concave & ~parallel;
  if (kConvex && any(convex_curved)) {
    selected.convex.append({dx, dy, dz, nx, ny, nz}, Packing(convex_curved));
  }
  if (kConcave && any(concave_curved)) {
    selected.concave.append({dx, dy, dz, nx, ny, nz}, Packing(concave_curved));
  }
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

/// Boxes that may hold a sample within reach, and the squares of their distances.
class NearBoxes {
 public:
  /// Those from `begin` to `end`, at most kCountedBoxes.
  void find(const Comparison& r, const Boxes& b, std::size_t begin, std::size_t end) {
    count_ = 0;
    for (std::size_t k = begin; k < end; k += kLanes) {
      append(laneNumbers() + static_cast<int>(k), distanceSq(r, b, k), r.max_distance_sq);
    }
  }

  /// Lets the reach shrink until so many are left.
  void shrink(Floats reach_sq, int most) {
    for (int shrinks = 0; shrinks < kMostShrinks && count_ > most; ++shrinks) {
      reach_sq *= kShrunkReachSq;
      store(Floats{} + __builtin_inff(), distance_sq_ + count_);
      const int all = count_;
      count_ = 0;
      for (int k = 0; k < all; k += kLanes) append(loadInts(number_ + k), load(distance_sq_ + k), reach_sq);
    }
  }

  int count() const { return count_; }
  std::size_t operator[](int k) const { return static_cast<std::size_t>(number_[k]); }

 private:
  PRIMITECT_INLINE void append(Ints number, Floats distance_sq, Floats reach_sq) {
    const Packing packing(distance_sq <= reach_sq);
    store(packing.packed(number), number_ + count_);
    store(packing.packed(distance_sq), distance_sq_ + count_);
    count_ += packing.count();
  }

  static Floats distanceSq(const Comparison& r, const Boxes& b, std::size_t k) {
    // Rounding keeps order, so that no sample is nearer than its box says: boxes and pairs are rounded alike.
    const auto outside = [](Floats low, Floats high, Floats v) { return larger(Floats{}, larger(low - v, v - high)); };
    const Floats x = outside(load(b.min_x + k), load(b.max_x + k), r.x);
    const Floats y = outside(load(b.min_y + k), load(b.max_y + k), r.y);
    const Floats z = outside(load(b.min_z + k), load(b.max_z + k), r.z);
    return dot(x, y, z, x, y, z);
  }

  int count_ = 0;
  int number_[kCountedBoxes + kLanes];
  float distance_sq_[kCountedBoxes + kLanes];
};

}  // namespace
}  // namespace primitect::kernels
