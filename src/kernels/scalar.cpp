// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The readable definition of the voting kernel: the paper's equations, one function each, and its algorithm 1.
#include <cmath>

#include "kernels/kernels.h"

namespace primitect::kernels {
namespace {

constexpr float kPi = 3.14159265358979f;

float dot(const Vector& a, const Vector& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

float squareRoot(float value) { return std::sqrt(std::fmax(value, 0.0f)); }

float angleOfCosine(float cosine) { return std::acos(std::fmin(std::fmax(cosine, -1.0f), 1.0f)); }

/// F2 = angle(d, n_r) and F3 = angle(d, n_i) from C (eq. 2).
float angleF2(const PairFeatures& c) { return angleOfCosine(c.c2 / std::sqrt(c.c1)); }
float angleF3(const PairFeatures& c) { return angleOfCosine(c.c3 / std::sqrt(c.c1)); }
float angleF4(const PairFeatures& c) { return angleOfCosine(c.c4); }

float constraintWeight(float deviation, float epsilon) {
  return std::fmax(0.0f, 1.0f - std::fabs(deviation) / epsilon);
}

/// A vote for one row, shared by two bins of R or s_r.
void add(const Accumulators& layout, int row, const LinearSpread& layers, float weight, Bins& bins) {
  for (int k = 0; k < 2; ++k) {
    const int bin = row * layout.radius_stride + layers.bin[k];
    bins.votes[bin] += weight * layers.weight[k];
    if (!(bins.votes[bin] > bins.most)) continue;
    bins.most = bins.votes[bin];
    bins.strongest = bin;
  }
  if (bins.cells) bins.cells[bins.cell_count++] = row * layout.radius_stride + layers.bin[0];
  bins.total += weight;
}

/// One bin takes all: what is left of an interpolation vote when spreading is switched off.
LinearSpread strongestOnly(LinearSpread spread) {
  const int strongest = spread.weight[1] > spread.weight[0] ? 1 : 0;
  return {{spread.bin[strongest], spread.bin[strongest]}, {1.0f, 0.0f}};
}

BallSpread strongestOnly(const BallSpread& spread) {
  int strongest = 0;
  for (int k = 1; k < 4; ++k) strongest = spread.weight[k] > spread.weight[strongest] ? k : strongest;
  const int bin = spread.bin[strongest];
  return {{bin, bin, bin, bin}, {1.0f, 0.0f, 0.0f, 0.0f}};
}

/// The stored bin of ring `ring` at azimuth bin j: opposite bins of the equator are one.
int ringBin(const AxisBall& ball, int ring, int j) {
  return ball.ring_start[ring] + (ring == ball.rings ? j % (ball.ring_size[ring] / 2) : j);
}

/// Around the pole: barycentric weights in the flat triangle (pole, two neighbours on ring 1). Outside of that
/// triangle, in the sliver between its edge and ring 1, the pole gets nothing.
BallSpread spreadAroundPole(const AxisBall& ball, float polar_angle, float azimuth) {
  const int size = ball.ring_size[1];
  const float sector = 2.0f * kPi / static_cast<float>(size);
  const LinearSpread side = spreadCircular(azimuth / sector, size);
  const float within = side.weight[1] * sector;
  const float radius = polar_angle / ball.step;
  float first = radius * std::sin(sector - within) / std::sin(sector);
  float second = radius * std::sin(within) / std::sin(sector);
  const float scale = std::fmax(1.0f, first + second);
  first /= scale;
  second /= scale;
  const float pole = std::fmax(0.0f, 1.0f - first - second);
  return {{0, ringBin(ball, 1, side.bin[0]), ringBin(ball, 1, side.bin[1]), 0}, {pole, first, second, 0.0f}};
}

void votePlane(const PairFeatures& c, const VotingRules& rules, Accumulators& accumulators) {
  accumulators.plane += rules.spread ? planeWeight(c, rules.epsilon) : 1.0f;
}

/// A pair on a surface seen from outside, or the flipped one of a surface seen from inside.
struct Pair {
  const Reference& reference;
  OrientedPoint other;
  PairFeatures c;
};

void voteCone(const Pair& pair, const VotingRules& rules, const Accumulators& layout, Bins& cone) {
  const float distance_in_bins = coneAxisDistance(pair.c) * layout.bins_per_meter;
  const Vector axis = coneAxis(pair.reference.sample, pair.other, pair.c);
  if (!(distance_in_bins < static_cast<float>(layout.radius_bins)) || !(dot(axis, axis) > 0.0f)) return;
  LinearSpread layers = spreadLinear(distance_in_bins, layout.radius_bins);
  BallSpread ball = spreadOnBall(layout.ball, axis);
  if (!rules.spread) {
    layers = strongestOnly(layers);
    ball = strongestOnly(ball);
  }
  for (int k = 0; k < 4; ++k) add(layout, ball.bin[k], layers, ball.weight[k], cone);
}

void voteCylinder(const Pair& pair, float weight, const VotingRules& rules, const Accumulators& layout,
                  Bins& cylinder) {
  const float bins_per_radian = static_cast<float>(layout.phi_bins) / kPi;
  LinearSpread layers = spreadLinear(pairRadius(pair.c) * layout.bins_per_meter, layout.radius_bins);
  LinearSpread angles = spreadCircular(cylinderAngle(pair.reference, pair.other) * bins_per_radian, layout.phi_bins);
  if (!rules.spread) {
    layers = strongestOnly(layers);
    angles = strongestOnly(angles);
  }
  for (int k = 0; k < 2; ++k) add(layout, angles.bin[k], layers, weight * angles.weight[k], cylinder);
}

void voteSphere(const Pair& pair, float weight, const VotingRules& rules, const Accumulators& layout, Bins& sphere) {
  const LinearSpread layers = spreadLinear(pairRadius(pair.c) * layout.bins_per_meter, layout.radius_bins);
  add(layout, 0, rules.spread ? layers : strongestOnly(layers), weight, sphere);
}

/// The branch of algorithm 1 for a pair whose normals are not parallel.
void voteCurved(const Pair& pair, const VotingRules& rules, const Accumulators& layout, CurvedBins& bins) {
  if (rules.cones) voteCone(pair, rules, layout, bins.cone);
  if (!(rules.cylinders || rules.spheres) || !anglesSymmetric(pair.c, rules)) return;
  if (!(pairRadius(pair.c) * layout.bins_per_meter < static_cast<float>(layout.radius_bins))) return;
  const float symmetry = rules.spread ? symmetryWeight(pair.c, rules.epsilon) : 1.0f;
  if (rules.cylinders) voteCylinder(pair, symmetry, rules, layout, bins.cylinder);
  if (!rules.spheres || !vectorsTriangular(pair.c, rules)) return;
  const float triangle = rules.spread ? triangleWeight(pair.c, rules.epsilon) : 1.0f;
  voteSphere(pair, symmetry * triangle, rules, layout, bins.sphere);
}

/// A reference and those that it is paired with.
struct Poll {
  const Reference& reference;
  Reference from_inside;
  const Samples& samples;
  const VotingRules& rules;
  Accumulators& accumulators;
};

void votePair(const Poll& poll, const OrientedPoint& other) {
  const VotingRules& rules = poll.rules;
  const PairFeatures c = pairFeatures(poll.reference.sample, other);
  if (!(0.0f < c.c1 && c.c1 <= rules.max_distance_sq)) return;
  const bool convex = rules.convex && isConvex(c);
  const bool concave = rules.concave && !convex && isConvex(flipped(c));
  if (normalsParallel(c, rules)) {
    if (rules.planes && (convex || concave || !rules.convex_planes) && pointsCoplanar(c, rules))
      votePlane(c, rules, poll.accumulators);
  } else if (convex) {
    voteCurved({poll.reference, other, c}, rules, poll.accumulators, poll.accumulators.convex);
  } else if (concave) {
    voteCurved({poll.from_inside, flipped(other), flipped(c)}, rules, poll.accumulators, poll.accumulators.concave);
  }
}

/// With the samples from `begin` to `end`, or to the last one.
void votePairs(const Poll& poll, std::size_t begin, std::size_t end) {
  const Samples& s = poll.samples;
  for (std::size_t i = begin; i < end && i < s.count; ++i) {
    votePair(poll, {{s.x[i], s.y[i], s.z[i]}, {s.nx[i], s.ny[i], s.nz[i]}});
  }
}

float outside(float low, float high, float v) { return std::fmax(0.0f, std::fmax(low - v, v - high)); }

/// 0 in the box.
float distanceSq(const Boxes& b, std::size_t box, const Vector& p) {
  const Vector away = {outside(b.min_x[box], b.max_x[box], p.x), outside(b.min_y[box], b.max_y[box], p.y),
                       outside(b.min_z[box], b.max_z[box], p.z)};
  return dot(away, away);
}

/// Those within reach of a reference, of which there are not too many; of boxes from `begin` to `end`, `near` tells it.
void findNear(const Poll& poll, std::size_t begin, std::size_t end, bool (&near)[kCountedBoxes]) {
  float reach_sq = poll.rules.max_distance_sq;
  for (int shrinks = 0; shrinks <= kMostShrinks; ++shrinks) {
    int count = 0;
    for (std::size_t box = begin; box < end; ++box) {
      near[box - begin] = distanceSq(*poll.samples.boxes, box, poll.reference.sample.point) <= reach_sq;
      count += near[box - begin] ? 1 : 0;
    }
    if (count <= poll.rules.most_boxes) return;
    reach_sq *= kShrunkReachSq;
  }
}

void voteBoxes(const Poll& poll, std::size_t begin, std::size_t end) {
  bool near[kCountedBoxes];
  findNear(poll, begin, end, near);
  for (std::size_t box = begin; box < end; ++box) {
    if (near[box - begin]) votePairs(poll, box * kBoxSamples, (box + 1) * kBoxSamples);
  }
}

}  // namespace

PairFeatures pairFeatures(const OrientedPoint& reference, const OrientedPoint& other) {
  const Vector d = {other.point.x - reference.point.x, other.point.y - reference.point.y,
                    other.point.z - reference.point.z};
  return {dot(d, d), dot(reference.normal, d), dot(other.normal, d), dot(reference.normal, other.normal)};
}

OrientedPoint flipped(const OrientedPoint& sample) {
  return {sample.point, {-sample.normal.x, -sample.normal.y, -sample.normal.z}};
}

Reference flipped(const Reference& reference) {
  return {flipped(reference.sample), reference.tangent_y, reference.tangent_z};
}

PairFeatures flipped(const PairFeatures& c) { return {c.c1, -c.c2, -c.c3, c.c4}; }

bool isConvex(const PairFeatures& c) { return c.c2 <= 0.0f && c.c3 >= 0.0f; }

bool normalsParallel(const PairFeatures& c, const VotingRules& rules) { return c.c4 > rules.cos_epsilon; }

bool pointsCoplanar(const PairFeatures& c, const VotingRules& rules) {
  return c.c2 * c.c2 < rules.sin_epsilon_sq * c.c1 && c.c3 * c.c3 < rules.sin_epsilon_sq * c.c1;
}

bool anglesSymmetric(const PairFeatures& c, const VotingRules& rules) {
  const float s2 = squareRoot(c.c1 - c.c2 * c.c2);
  const float s3 = squareRoot(c.c1 - c.c3 * c.c3);
  return s2 * s3 - c.c2 * c.c3 > rules.cos_epsilon * c.c1;
}

bool vectorsTriangular(const PairFeatures& c, const VotingRules& rules) {
  const float s2 = squareRoot(c.c1 - c.c2 * c.c2);
  const float s3 = squareRoot(c.c1 - c.c3 * c.c3);
  const float s4 = squareRoot(1.0f - c.c4 * c.c4);
  return c.c2 * c.c3 * c.c4 + s2 * s3 * c.c4 + s2 * c.c3 * s4 - c.c2 * s3 * s4 > rules.cos_epsilon * c.c1;
}

float planeWeight(const PairFeatures& c, float epsilon) {
  return constraintWeight(angleF4(c), epsilon) * constraintWeight(angleF2(c) - 0.5f * kPi, epsilon) *
         constraintWeight(angleF3(c) - 0.5f * kPi, epsilon);
}

float symmetryWeight(const PairFeatures& c, float epsilon) {
  return constraintWeight(angleF2(c) + angleF3(c) - kPi, epsilon);
}

float triangleWeight(const PairFeatures& c, float epsilon) {
  return constraintWeight(angleF2(c) - angleF3(c) - angleF4(c), epsilon);
}

float pairRadius(const PairFeatures& c) { return (c.c2 - c.c3) / (2.0f * (c.c4 - 1.0f)); }

float coneAxisDistance(const PairFeatures& c) { return c.c3 / (1.0f - c.c4); }

Vector coneAxis(const OrientedPoint& reference, const OrientedPoint& other, const PairFeatures& c) {
  const float along_reference = c.c3 / (1.0f - c.c4);
  const float along_other = c.c2 / (1.0f - c.c4);
  const auto component = [&](float p_i, float p_r, float n_r, float n_i) {
    return p_i - p_r + along_reference * n_r + along_other * n_i;
  };
  return {component(other.point.x, reference.point.x, reference.normal.x, other.normal.x),
          component(other.point.y, reference.point.y, reference.normal.y, other.normal.y),
          component(other.point.z, reference.point.z, reference.normal.z, other.normal.z)};
}

float cylinderAngle(const Reference& reference, const OrientedPoint& other) {
  // In the frame (n_r, tangent_y, tangent_z), n_r x n_i = (0, -n_i.tangent_z, n_i.tangent_y).
  const float angle = std::atan2(dot(other.normal, reference.tangent_y), -dot(other.normal, reference.tangent_z));
  const float folded = angle < 0.0f ? angle + kPi : angle;
  return folded < kPi ? folded : 0.0f;
}

LinearSpread spreadLinear(float value_in_bins, int bins) {
  const float last = static_cast<float>(bins - 1);
  const float position = std::fmin(std::fmax(value_in_bins - 0.5f, 0.0f), last);
  const int lower = static_cast<int>(position);
  const float fraction = position - static_cast<float>(lower);
  return {{lower, lower + 1 < bins ? lower + 1 : lower}, {1.0f - fraction, fraction}};
}

LinearSpread spreadCircular(float value_in_bins, int bins) {
  const float whole = std::floor(value_in_bins);
  const float fraction = value_in_bins - whole;
  const int lower = (static_cast<int>(whole) % bins + bins) % bins;
  return {{lower, (lower + 1) % bins}, {1.0f - fraction, fraction}};
}

BallSpread spreadOnBall(const AxisBall& ball, const Vector& axis) {
  const float sign = axis.z < 0.0f ? -1.0f : 1.0f;
  const float in_plane = std::sqrt(axis.x * axis.x + axis.y * axis.y);
  const float polar_angle = std::atan2(in_plane, sign * axis.z);
  const float azimuth = std::atan2(sign * axis.y, sign * axis.x);
  if (polar_angle < ball.step) return spreadAroundPole(ball, polar_angle, azimuth);
  const float position = std::fmin(polar_angle / ball.step, static_cast<float>(ball.rings));
  const int inner = static_cast<int>(std::fmin(position, static_cast<float>(ball.rings - 1)));
  const float outer_weight = position - static_cast<float>(inner);
  BallSpread result;
  for (int k = 0; k < 2; ++k) {
    const int ring = inner + k;
    const int size = ball.ring_size[ring];
    const float ring_weight = k == 0 ? 1.0f - outer_weight : outer_weight;
    const LinearSpread side = spreadCircular(azimuth / (2.0f * kPi) * static_cast<float>(size), size);
    for (int j = 0; j < 2; ++j) {
      result.bin[2 * k + j] = ringBin(ball, ring, side.bin[j]);
      result.weight[2 * k + j] = ring_weight * side.weight[j];
    }
  }
  return result;
}

void vote(const Reference& reference, const Samples& samples, const VotingRules& rules, Accumulators& accumulators) {
  const Poll poll = {reference, flipped(reference), samples, rules, accumulators};
  if (!samples.boxes || rules.most_boxes == 0) {
    votePairs(poll, 0, samples.count);
    return;
  }
  const std::size_t boxes = samples.boxes->count;
  for (std::size_t begin = 0; begin < boxes; begin += kCountedBoxes) {
    voteBoxes(poll, begin, boxes - begin < kCountedBoxes ? boxes : begin + kCountedBoxes);
  }
}

const Kernels kScalar = {"scalar", vote};

}  // namespace primitect::kernels
