// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// vote() of scalar.cpp in steps over lists, kLanes at a time: select pairs, find their parameters and weights, spread
// them over rows, add them to the bins. For a kernel file that has included its lanes.
//
// A convex and a concave pair differ in the signs of C2 and C3 only; with their magnitudes, the equations are the same.
#pragma once

#include "kernels/kernels.h"
#include "kernels/vector_bins.h"
#include "kernels/vector_lists.h"
#include "kernels/vector_math.h"
#include "kernels/vector_pairs.h"
#include "kernels/vector_spread.h"

namespace primitect::kernels {
namespace {

/// Fields of votes on their way to the bins. Radius: R or s_r in bins. Position: in steps of rings from the pole, and
/// in turns or bins around it.
enum ConeField { kConeRadius, kAxisX, kAxisY, kAxisZ, kPolar = kAxisX, kTurns = kAxisY };
enum CylinderField { kCylinderRadius, kCylinderWeight, kPhiY, kPhiX };
enum SphereField { kSphereRadius, kSphereWeight };

/// What all pairs of a reference share.
struct Ballot {
  const Reference& reference;
  const VotingRules& rules;
  Accumulators& accumulators;
  RingTable rings;
};

/// Weight of a constraint whose deviation has this sine.
Floats constraintWeight(Floats sine, float inverse_epsilon) {
  return larger(1.0f - absolute(smallArcSine(sine)) * inverse_epsilon, Floats{});
}

/// Of the square of a length and its part along a normal: the part across the normal.
Floats across(Floats length_sq, Floats along) { return squareRoot(larger(length_sq - along * along, Floats{})); }

void votePlanes(LaneList<4>& pairs, const VotingRules& rules, Accumulators& accumulators) {
  pairs.pad();
  const float inverse_epsilon = 1.0f / rules.epsilon;
  Floats sum = {};
  for (int i = 0; i < pairs.count(); i += kLanes) {
    const Floats c2 = pairs.at(kC2, i), c3 = pairs.at(kC3, i), c4 = pairs.at(kC4, i);
    const Floats inverse = 1.0f / squareRoot(pairs.at(kC1, i));
    // cos F4 = 1 - 2 sin^2(F4 / 2), without loss where C4 is nearly 1.
    const Floats f4 = 2.0f * smallArcSine(squareRoot(larger(0.5f * (1.0f - c4), Floats{})));
    Floats weight = larger(1.0f - f4 * inverse_epsilon, Floats{});
    weight *= constraintWeight(c2 * inverse, inverse_epsilon) * constraintWeight(c3 * inverse, inverse_epsilon);
    if (!rules.spread) weight = Floats{} + 1.0f;
    sum += pairs.valid(i) ? weight : Floats{};
  }
  for (int k = 0; k < kLanes; ++k) accumulators.plane += sum[k];
  pairs.clear();
}

/// Pairs that vote for curved surfaces, and their features.
struct CurvedPairs {
  CurvedPairs(const OrientedPoint& r, LaneList<6>& selected) : pairs(selected) {
    const Floats nx = Floats{} + r.normal.x, ny = Floats{} + r.normal.y, nz = Floats{} + r.normal.z;
    pairs.pad();
    for (int i = 0; i < pairs.count(); i += kLanes) {
      const FeatureLanes c = features(nx, ny, nz, pairs.at(kDx, i), pairs.at(kDy, i), pairs.at(kDz, i),
                                      pairs.at(kNx, i), pairs.at(kNy, i), pairs.at(kNz, i));
      store(c.c1, features_[kC1] + i), store(c.c2, features_[kC2] + i);
      store(c.c3, features_[kC3] + i), store(c.c4, features_[kC4] + i);
    }
  }

  int count() const { return pairs.count(); }
  Ints valid(int i) const { return pairs.valid(i); }
  Floats at(PairField field, int i) const { return pairs.at(field, i); }
  Floats at(PairFeature feature, int i) const { return load(features_[feature] + i); }

 private:
  LaneList<6>& pairs;
  alignas(64) float features_[4][kRoom];
};

/// Eq. 9 and 10.
void findCones(const Ballot& b, const CurvedPairs& pairs, LaneList<4>& cones) {
  const OrientedPoint& r = b.reference.sample;
  const float bins = static_cast<float>(b.accumulators.radius_bins);
  for (int i = 0; i < pairs.count(); i += kLanes) {
    const Floats inverse = 1.0f / (1.0f - pairs.at(kC4, i));
    const Floats along_reference = pairs.at(kC3, i) * inverse, along_other = pairs.at(kC2, i) * inverse;
    const Floats radius = absolute(along_reference) * b.accumulators.bins_per_meter;
    const Floats x = pairs.at(kDx, i) + along_reference * r.normal.x + along_other * pairs.at(kNx, i);
    const Floats y = pairs.at(kDy, i) + along_reference * r.normal.y + along_other * pairs.at(kNy, i);
    const Floats z = pairs.at(kDz, i) + along_reference * r.normal.z + along_other * pairs.at(kNz, i);
    const Ints cone = pairs.valid(i) & (radius < bins) & (x * x + y * y + z * z > 0.0f);
    cones.append({radius, x, y, z}, Packing(cone));
  }
}

void spreadCones(const Ballot& b, const CurvedPairs& pairs, VoteList<4>& votes) {
  LaneList<4> cones;
  findCones(b, pairs, cones);
  cones.pad();
  for (int i = 0; i < cones.count(); i += kLanes) {
    const BallPosition position = b.rings.locate(cones.at(kAxisX, i), cones.at(kAxisY, i), cones.at(kAxisZ, i));
    cones.set(kPolar, i, position.polar);
    cones.set(kTurns, i, position.turns);
  }
  for (int i = 0; i < cones.count(); i += kLanes) {
    ShareLanes shares[4];
    b.rings.spread({cones.at(kPolar, i), cones.at(kTurns, i)}, shares);
    if (!b.rules.spread) strongestOnly(shares);
    const LayerLanes layers = layersOf(cones.at(kConeRadius, i), b.accumulators.radius_bins, b.rules.spread);
    votes.set(i, shares, layers, b.accumulators.radius_stride);
  }
  votes.count = cones.count();
}

/// Cylinders and spheres: the conditions AS and VT and the deviations from them, through sums of angles. With s the
/// parts of d across the normals, cos F = C / |d| and sin F = s / |d|.
void findSymmetric(const Ballot& b, const CurvedPairs& pairs, LaneList<4>& cylinders, LaneList<2>& spheres) {
  const Vector& t = b.reference.tangent_y;
  const Vector& u = b.reference.tangent_z;
  const float bins = static_cast<float>(b.accumulators.radius_bins);
  const float inverse_epsilon = 1.0f / b.rules.epsilon, half_bins_per_meter = 0.5f * b.accumulators.bins_per_meter;
  const Floats one = Floats{} + 1.0f;
  for (int i = 0; i < pairs.count(); i += kLanes) {
    const Floats c1 = pairs.at(kC1, i), c2 = absolute(pairs.at(kC2, i)), c3 = absolute(pairs.at(kC3, i));
    const Floats c4 = pairs.at(kC4, i), nx = pairs.at(kNx, i), ny = pairs.at(kNy, i), nz = pairs.at(kNz, i);
    const Floats s2 = across(c1, c2), s3 = across(c1, c3), s4 = across(one, c4);
    const Floats radius = half_bins_per_meter * (c2 + c3) / (1.0f - c4);
    const Floats inverse_c1 = 1.0f / larger(c1, Floats{} + kTiny);
    const Floats smallest_cosine = b.rules.cos_epsilon * c1;
    const Ints symmetric = pairs.valid(i) & (s2 * s3 + c2 * c3 > smallest_cosine) & (radius < bins);
    Floats weight = one, triangle_weight = one;
    if (b.rules.spread) weight = constraintWeight((s2 * c3 - c2 * s3) * inverse_c1, inverse_epsilon);
    const Floats y = nx * t.x + ny * t.y + nz * t.z, x = nx * u.x + ny * u.y + nz * u.z;
    cylinders.append({radius, weight, y, -x}, Packing(symmetric));
    // |d|^2 times cosine and sine of F2 - F3.
    const Floats cosine = s2 * s3 - c2 * c3, sine = s2 * c3 + c2 * s3;
    const Ints triangular = symmetric & (c4 * cosine + s4 * sine > smallest_cosine);
    if (b.rules.spread) triangle_weight = constraintWeight((c4 * sine - s4 * cosine) * inverse_c1, inverse_epsilon);
    spheres.append({radius, weight * triangle_weight}, Packing(triangular));
  }
}

void spreadCylinders(const Ballot& b, LaneList<4>& cylinders, VoteList<2>& votes) {
  const Accumulators& a = b.accumulators;
  const float bins_per_radian = static_cast<float>(a.phi_bins) / kPi;
  cylinders.pad();
  for (int i = 0; i < cylinders.count(); i += kLanes) {
    const Floats y = cylinders.at(kPhiY, i), x = cylinders.at(kPhiX, i);
    const Ints flip = y < 0.0f;
    const Floats position = angleInHalfPlane(flip ? -y : y, flip ? -x : x) * bins_per_radian;
    const TurnLanes side = turnOf(position, Ints{} + a.phi_bins);
    ShareLanes shares[2] = {{side.lower, 1.0f - side.upper_weight}, {side.upper, side.upper_weight}};
    if (!b.rules.spread) strongestOnly(shares);
    for (ShareLanes& share : shares) share.weight *= cylinders.at(kCylinderWeight, i);
    votes.set(i, shares, layersOf(cylinders.at(kCylinderRadius, i), a.radius_bins, b.rules.spread), a.radius_stride);
  }
  votes.count = cylinders.count();
}

void spreadSpheres(const Ballot& b, LaneList<2>& spheres, RowVoteList& votes) {
  const Accumulators& a = b.accumulators;
  spheres.pad();
  for (int i = 0; i < spheres.count(); i += kLanes) {
    votes.set(i, spheres.at(kSphereWeight, i), layersOf(spheres.at(kSphereRadius, i), a.radius_bins, b.rules.spread));
  }
  votes.count = spheres.count();
}

/// A vote waits for the one before that went to the same bin. Votes for other kinds, in between, need not.
void addTogether(const VoteList<4>& cone_votes, const VoteList<2>& cylinder_votes, const RowVoteList& sphere_votes,
                 int radius_stride, CurvedBins& bins) {
  Addition<4> cones(cone_votes, bins.cone);
  Addition<2> cylinders(cylinder_votes, bins.cylinder);
  RowAddition spheres(sphere_votes, bins.sphere, radius_stride);
  for (int i = 0; i < cone_votes.count || i < cylinder_votes.count || i < sphere_votes.count; ++i) {
    cones.add(i);
    cylinders.add(i);
    spheres.add(i);
  }
  cones.finish();
  cylinders.finish();
  spheres.finish();
}

void voteCurved(const Ballot& b, LaneList<6>& selected, CurvedBins& bins) {
  const CurvedPairs pairs(b.reference.sample, selected);
  VoteList<4> cone_votes;
  VoteList<2> cylinder_votes;
  RowVoteList sphere_votes;
  if (b.rules.cones) spreadCones(b, pairs, cone_votes);
  if (b.rules.cylinders || b.rules.spheres) {
    LaneList<4> cylinders;
    LaneList<2> spheres;
    findSymmetric(b, pairs, cylinders, spheres);
    if (b.rules.cylinders) spreadCylinders(b, cylinders, cylinder_votes);
    if (b.rules.spheres) spreadSpheres(b, spheres, sphere_votes);
  }
  addTogether(cone_votes, cylinder_votes, sphere_votes, b.accumulators.radius_stride, bins);
  selected.clear();
}

/// Empties the lists of selected pairs.
void castVotes(const Ballot& b, SelectedPairs& selected) {
  votePlanes(selected.plane, b.rules, b.accumulators);
  voteCurved(b, selected.convex, b.accumulators.convex);
  if (b.rules.concave) voteCurved(b, selected.concave, b.accumulators.concave);
}

template <bool kConvex, bool kConcave>
void visitNear(const Ballot& b, const Samples& samples, SelectedPairs& selected) {
  constexpr std::size_t kBatch = kCountedBoxes;
  const Comparison reference(b.reference.sample, b.rules);
  const Boxes& boxes = *samples.boxes;
  NearBoxes near;
  for (std::size_t start = 0; start < boxes.count; start += kBatch) {
    near.find(reference, boxes, start, start + kBatch < boxes.count ? start + kBatch : boxes.count);
    if (b.rules.most_boxes > 0) near.shrink(reference.max_distance_sq, b.rules.most_boxes);
    for (int k = 0; k < near.count(); ++k) {
      selectBox<kConvex, kConcave>(reference, samples, near[k], selected);
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
