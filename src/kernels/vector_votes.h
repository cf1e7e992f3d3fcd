// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// vote() of scalar.cpp, kLanes pairs at a time: select, weigh, spread, add. For a kernel file that has included its
// lanes.
//
// A convex and a concave pair differ in the signs of C2 and C3 only; with their magnitudes, the equations are the same.
#pragma once

#include "kernels/kernels.h"
#include "kernels/vector_math.h"
#include "kernels/vector_pairs.h"
#include "kernels/vector_spread.h"

namespace primitect::kernels {
namespace {

/// The votes of two cells, each of them two neighbouring bins.
using Cells = float __attribute__((vector_size(16)));
using CellPair = double __attribute__((vector_size(16)));

/// The most votes seen, for each of the four bins of two cells, and where they were seen first.
class Record {
 public:
  explicit Record(float most) : most_(Cells{} + most) {}

  void see(Cells votes, int where) {
    const Places more = votes > most_;
    most_ = more ? votes : most_;
    where_ = more ? Places{} + where : where_;
  }

  /// To the bins, if it beats what they had. `where` is an index of the two cells in the list.
  void report(const int* cells, Bins& bins) const {
    int lane = 0;
    for (int k = 1; k < 4; ++k) {
      if (most_[k] > most_[lane] || (most_[k] == most_[lane] && where_[k] < where_[lane])) lane = k;
    }
    if (!(most_[lane] > bins.most)) return;
    bins.most = most_[lane];
    bins.strongest = cells[where_[lane] + lane / 2] + lane % 2;
  }

 private:
  using Places = int __attribute__((vector_size(16)));

  Cells most_;
  Places where_ = {};
};

/// Adds to the bins of two cells, the second one last: they may be the same one if the first addend is 0.
Cells addTwo(float* bins, const int* cell, Cells addend) {
  double first, second;
  __builtin_memcpy(&first, bins + cell[0], sizeof first);
  __builtin_memcpy(&second, bins + cell[1], sizeof second);
  const Cells sum = (Cells)CellPair{first, second} + addend;
  first = ((CellPair)sum)[0];
  second = ((CellPair)sum)[1];
  __builtin_memcpy(bins + cell[0], &first, sizeof first);
  __builtin_memcpy(bins + cell[1], &second, sizeof second);
  return sum;
}

/// Votes for kShares rows each, about to be added to the bins; a vote is four cells and four weights, of which the
/// first kShares count.
template <int kShares>
class VoteList {
 public:
  void append(const ShareLanes (&shares)[kShares], const LayerLanes& layers, int radius_stride,
              const Packing& packing) {
    Floats cells[4] = {}, weights[4] = {};
    for (int k = 0; k < kShares; ++k) {
      cells[k] = packing.packed((Floats)(shares[k].row * radius_stride + layers.lower));
      weights[k] = packing.packed(shares[k].weight);
    }
    storeRows(cells, reinterpret_cast<float*>(cells_) + 4 * count_);
    storeRows(weights, weights_ + 4 * count_);
    store(packing.packed(layers.upper_weight), upper_weights_ + count_);
    count_ += packing.count();
  }

  void addTo(Bins& bins) const {
    Record record(bins.most);
    Cells total = {};
    for (int i = 0; i < count_; ++i) {
      const int* cell = cells_ + 4 * i;
      Cells weight, upper = Cells{} + upper_weights_[i];
      __builtin_memcpy(&weight, weights_ + 4 * i, sizeof weight);
      const Cells share = Cells{1.0f, 0.0f, 1.0f, 0.0f} + upper * Cells{-1.0f, 1.0f, -1.0f, 1.0f};
      total += weight;
      record.see(addTwo(bins.votes, cell, Cells{weight[0], weight[0], weight[1], weight[1]} * share), 4 * i);
      if (kShares < 4) continue;
      record.see(addTwo(bins.votes, cell + 2, Cells{weight[2], weight[2], weight[3], weight[3]} * share), 4 * i + 2);
    }
    bins.total += (total[0] + total[1]) + (total[2] + total[3]);
    record.report(cells_, bins);
    int* cells = bins.cells + bins.cell_count;
    for (int i = 0; i < count_; ++i) {
      for (int k = 0; k < kShares; ++k) *cells++ = cells_[4 * i + k];
    }
    bins.cell_count += static_cast<std::size_t>(count_) * kShares;
  }

 private:
  int count_ = 0;
  alignas(64) int cells_[4 * kRoom];
  alignas(64) float weights_[4 * kRoom];
  float upper_weights_[kRoom];
};

/// Weight of a constraint whose deviation has this sine.
Floats constraintWeight(Floats sine, float epsilon) {
  return larger(1.0f - absolute(smallArcSine(sine)) * (1.0f / epsilon), Floats{});
}

/// Of the square of `length`, C1, and its part along a normal: the part across the normal.
Floats across(Floats length_sq, Floats along) { return squareRoot(larger(length_sq - along * along, Floats{})); }

/// What all pairs of a reference share.
struct Ballot {
  const Reference& reference;
  const VotingRules& rules;
  Accumulators& accumulators;
  RingTable rings;
};

void votePlanes(PairList& list, const VotingRules& rules, Accumulators& accumulators) {
  list.pad();
  Floats sum = {};
  for (int i = 0; i < list.count(); i += kLanes) {
    const PairLanes p = list.at(i);
    const Floats inverse = 1.0f / squareRoot(p.c1);
    // cos F4 = 1 - 2 sin^2(F4 / 2), without loss where C4 is nearly 1.
    const Floats f4 = 2.0f * smallArcSine(squareRoot(larger(0.5f * (1.0f - p.c4), Floats{})));
    Floats weight = larger(1.0f - f4 * (1.0f / rules.epsilon), Floats{});
    weight *= constraintWeight(p.c2 * inverse, rules.epsilon) * constraintWeight(p.c3 * inverse, rules.epsilon);
    if (!rules.spread) weight = Floats{} + 1.0f;
    sum += list.valid(i) ? weight : Floats{};
  }
  for (int k = 0; k < kLanes; ++k) accumulators.plane += sum[k];
  list.clear();
}

void voteCones(const Ballot& b, const PairLanes& p, Floats inverse, Ints valid, VoteList<4>& votes) {
  const OrientedPoint& r = b.reference.sample;
  const Floats along_reference = p.c3 * inverse, along_other = p.c2 * inverse;
  const Floats distance_in_bins = absolute(along_reference) * b.accumulators.bins_per_meter;
  const Floats x = p.dx + along_reference * r.normal.x + along_other * p.nx;
  const Floats y = p.dy + along_reference * r.normal.y + along_other * p.ny;
  const Floats z = p.dz + along_reference * r.normal.z + along_other * p.nz;
  const Ints cone =
      valid & (distance_in_bins < static_cast<float>(b.accumulators.radius_bins)) & (x * x + y * y + z * z > 0.0f);
  ShareLanes shares[4];
  b.rings.spread(x, y, z, shares);
  if (!b.rules.spread) strongestOnly(shares);
  votes.append(shares, layersOf(distance_in_bins, b.accumulators.radius_bins, b.rules.spread),
               b.accumulators.radius_stride, Packing(cone));
}

/// Rows of phi, as cylinderAngle().
void cylinderRows(const Ballot& b, const PairLanes& p, Floats weight, ShareLanes (&shares)[2]) {
  const Vector& t = b.reference.tangent_y;
  const Vector& u = b.reference.tangent_z;
  const Floats y = p.nx * t.x + p.ny * t.y + p.nz * t.z;
  const Floats x = -(p.nx * u.x + p.ny * u.y + p.nz * u.z);
  const Ints flip = y < 0.0f;
  const float bins_per_radian = static_cast<float>(b.accumulators.phi_bins) / kPi;
  const Floats position = angleInHalfPlane(flip ? -y : y, flip ? -x : x) * bins_per_radian;
  const TurnLanes side = turnOf(position, Ints{} + b.accumulators.phi_bins);
  shares[0] = {side.lower, 1.0f - side.upper_weight};
  shares[1] = {side.upper, side.upper_weight};
  if (!b.rules.spread) strongestOnly(shares);
  for (ShareLanes& share : shares) share.weight *= weight;
}

/// Cylinders and spheres: the conditions AS and VT and the deviations from them through sums of angles. With s the
/// parts of d across the normals, cos F = C / |d| and sin F = s / |d|.
void voteSymmetric(const Ballot& b, const PairLanes& p, Floats inverse, Ints valid, VoteList<2>& cylinders,
                   VoteList<2>& spheres) {
  const Accumulators& a = b.accumulators;
  const Floats c2 = absolute(p.c2), c3 = absolute(p.c3);
  const Floats s2 = across(p.c1, c2), s3 = across(p.c1, c3), s4 = across(Floats{} + 1.0f, p.c4);
  const Floats radius_in_bins = 0.5f * (c2 + c3) * inverse * a.bins_per_meter;
  const Floats smallest_cosine = b.rules.cos_epsilon * p.c1;
  const Ints symmetric =
      valid & (s2 * s3 + c2 * c3 > smallest_cosine) & (radius_in_bins < static_cast<float>(a.radius_bins));
  if (!any(symmetric)) return;
  const LayerLanes layers = layersOf(radius_in_bins, a.radius_bins, b.rules.spread);
  const Floats inverse_c1 = 1.0f / larger(p.c1, Floats{} + kTiny);
  const Floats one = Floats{} + 1.0f;
  const Floats symmetry = b.rules.spread ? constraintWeight((s2 * c3 - c2 * s3) * inverse_c1, b.rules.epsilon) : one;
  if (b.rules.cylinders) {
    ShareLanes shares[2];
    cylinderRows(b, p, symmetry, shares);
    cylinders.append(shares, layers, a.radius_stride, Packing(symmetric));
  }
  // |d|^2 times cosine and sine of F2 - F3.
  const Floats cosine = s2 * s3 - c2 * c3, sine = s2 * c3 + c2 * s3;
  const Ints triangular = symmetric & (p.c4 * cosine + s4 * sine > smallest_cosine);
  if (!b.rules.spheres || !any(triangular)) return;
  const Floats triangle =
      b.rules.spread ? constraintWeight((p.c4 * sine - s4 * cosine) * inverse_c1, b.rules.epsilon) : one;
  const ShareLanes shares[2] = {{Ints{}, Floats{}}, {Ints{}, symmetry * triangle}};
  spheres.append(shares, layers, a.radius_stride, Packing(triangular));
}

void voteCurved(const Ballot& b, PairList& list, CurvedBins& bins) {
  list.pad();
  VoteList<4> cones;
  VoteList<2> cylinders;
  VoteList<2> spheres;
  for (int i = 0; i < list.count(); i += kLanes) {
    const PairLanes p = list.at(i);
    const Ints valid = list.valid(i);
    const Floats inverse = 1.0f / (1.0f - p.c4);
    if (b.rules.cones) voteCones(b, p, inverse, valid, cones);
    if (b.rules.cylinders || b.rules.spheres) voteSymmetric(b, p, inverse, valid, cylinders, spheres);
  }
  cones.addTo(bins.cone);
  cylinders.addTo(bins.cylinder);
  spheres.addTo(bins.sphere);
  list.clear();
}

/// Empties the lists of selected pairs.
void castVotes(const Ballot& b, SelectedPairs& selected) {
  votePlanes(selected.plane, b.rules, b.accumulators);
  voteCurved(b, selected.convex, b.accumulators.convex);
  if (b.rules.concave) voteCurved(b, selected.concave, b.accumulators.concave);
}

template <bool kConvex, bool kConcave>
void visitNear(const Ballot& b, const Samples& samples, SelectedPairs& selected) {
  constexpr std::size_t kBatch = 256;
  const Comparison reference(b.reference.sample, b.rules);
  const Boxes& boxes = *samples.boxes;
  int near[kBatch + kLanes];
  for (std::size_t start = 0; start < boxes.count; start += kBatch) {
    const std::size_t end = start + kBatch < boxes.count ? start + kBatch : boxes.count;
    int count = 0;
    for (std::size_t k = start; k < end; k += kLanes) {
      const Packing packing(nearBoxes(reference, boxes, k));
      store(packing.packed(laneNumbers() + static_cast<int>(k)), near + count);
      count += packing.count();
    }
    for (int k = 0; k < count; ++k) {
      selectBox<kConvex, kConcave>(reference, samples, static_cast<std::size_t>(near[k]), selected);
      if (selected.full()) castVotes(b, selected);
    }
  }
}

template <bool kConvex, bool kConcave>
void visitAll(const Ballot& b, const Samples& samples, SelectedPairs& selected) {
  const Comparison reference(b.reference.sample, b.rules);
  for (std::size_t k = 0; k * kBoxSamples < samples.count; ++k) {
    selectBox<kConvex, kConcave>(reference, samples, k, selected);
    if (selected.full()) castVotes(b, selected);
  }
}

template <bool kConvex, bool kConcave>
void voteOnSides(const Ballot& ballot, const Samples& samples) {
  SelectedPairs selected;
  if (samples.boxes) {
    visitNear<kConvex, kConcave>(ballot, samples, selected);
  } else {
    visitAll<kConvex, kConcave>(ballot, samples, selected);
  }
  castVotes(ballot, selected);
}

void voteInLanes(const Reference& reference, const Samples& samples, const VotingRules& rules,
                 Accumulators& accumulators) {
  const Ballot ballot = {reference, rules, accumulators, RingTable(accumulators.ball)};
  if (rules.convex && rules.concave) {
    voteOnSides<true, true>(ballot, samples);
  } else if (rules.concave) {
    voteOnSides<false, true>(ballot, samples);
  } else {
    voteOnSides<true, false>(ballot, samples);
  }
}

}  // namespace
}  // namespace primitect::kernels
