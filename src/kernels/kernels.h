// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The inner loop of the method: pairs, features, conditions, weights and votes. scalar.cpp is the definition, the
// others are faster; dispatch.cpp chooses.
//
// Symbols follow the paper (PrimiTect, ICRA 2020): d = p_i - p_r, features C1..C4 (eq. 2), conditions NP, PC, AS, VT
// (table II), angles F1..F4 (eq. 1), s_r (eq. 9). Lengths are in m, angles in rad, all vectors of normals are unit.
#pragma once

#include <cstddef>

namespace primitect::kernels {

struct Vector {
  float x, y, z;
};

/// A point with its unit normal, towards the sensor: outward on a surface seen from outside, inward on one seen from
/// inside.
struct OrientedPoint {
  Vector point;
  Vector normal;
};

/// The sample whose votes are being collected, with a right-handed frame (normal, tangent_y, tangent_z): the rows of
/// the paper's rotation R_x.
struct Reference {
  OrientedPoint sample;
  Vector tangent_y;
  Vector tangent_z;
};

/// Rows of the accumulators are no longer.
constexpr int kMostRadiusStride = 512;

/// Samples in one of these boxes are so many neighbours in memory; of the last box perhaps fewer.
constexpr int kBoxSamples = 16;

/// Boxes around runs of samples, so that a kernel can pass over runs which are too far away. Samples that cannot vote
/// (NaN) may be outside. The arrays are padded to a multiple of kBoxSamples with boxes that are nowhere (NaN).
struct Boxes {
  const float *min_x, *min_y, *min_z, *max_x, *max_y, *max_z;
  std::size_t count;
};

/// Samples as structure of arrays, `count` of each.
struct Samples {
  const float *x, *y, *z, *nx, *ny, *nz;
  std::size_t count;
  const Boxes* boxes = nullptr;  ///< null: every pair is looked at; the votes are the same unless there are most_boxes
};

/// C = (|d|^2, n_r.d, n_i.d, n_r.n_i), eq. 2.
struct PairFeatures {
  float c1, c2, c3, c4;
};

/// Boxes are counted among so many at a time, and the reach of a reference shrinks at most so often, each time to this
/// share of its square.
constexpr int kCountedBoxes = 512;
constexpr int kMostShrinks = 16;
constexpr float kShrunkReachSq = 0.75f;

/// Who may vote, and how.
struct VotingRules {
  float max_distance_sq;  ///< a pair farther apart does not vote (m^2)
  float epsilon;          ///< tolerance of NP, PC, AS and VT (rad)
  int most_boxes = 0;  ///< boxes that are looked at, of each kCountedBoxes: with more within reach, it shrinks; 0: all
  float cos_epsilon;
  float sin_epsilon_sq;
  bool convex, concave;  ///< which sides of curved surfaces vote: seen from outside, from inside
  bool spread;           ///< linear interpolation votes and constraint weights; false: 1 into the nearest bin
  bool convex_planes;    ///< a plane pair must lie on a side that votes, too (algorithm 1), not curved ones alone
  bool planes, spheres, cylinders, cones;
};

/// Weights on neighbouring bins; they add up to 1. A bin may be named twice.
struct LinearSpread {
  int bin[2];
  float weight[2];
};
struct BallSpread {
  int bin[4];
  float weight[4];
};

/// Accumulator ball for axes without sign, after Borrmann et al. 2011: the pole, then rings of nearly square bins
/// (centre of ring k at k * step from the pole), the last of them on the equator, where only half a ring is needed.
struct AxisBall {
  int rings;              ///< of which the last is the equator
  float step;             ///< angle between rings (rad)
  const int* ring_start;  ///< index of the first bin of ring k, k = 1 .. rings; bin 0 is the pole
  const int* ring_size;   ///< bins of the full turn of ring k; of the equator's, only the first half is stored
};

/// Votes for one kind of curved shape. Bins are in rows, one for each direction, of radius_stride bins of R or s_r. A
/// vote is shared by neighbours in the row; its cell is the first of the two.
struct Bins {
  float* votes;            ///< all 0 before a reference votes
  int* cells;              ///< null, or the cells that got votes, some of them repeatedly: all that is to be cleared
  std::size_t cell_count;  ///< 0 before a reference votes; grows with every pair by 4 at most
  float total;             ///< sum of all votes
  float most;              ///< the largest number of votes in a bin
  int strongest;           ///< such a bin; only if `most` is not 0
};

/// Votes for curved surfaces seen from one side; empty where that side does not vote.
struct CurvedBins {
  Bins sphere;    ///< one row
  Bins cylinder;  ///< phi_bins rows
  Bins cone;      ///< ball_bins rows
};

/// Votes of one reference; the caller clears them.
struct Accumulators {
  float plane;  ///< the same from either side
  CurvedBins convex, concave;
  int radius_bins;       ///< at least 2
  int radius_stride;     ///< from row to row: more than radius_bins, a multiple of 16, at most kMostRadiusStride
  int phi_bins;          ///< over [0, pi)
  float bins_per_meter;  ///< of R and s_r
  AxisBall ball;
};

/// Eq. 2.
PairFeatures pairFeatures(const OrientedPoint& reference, const OrientedPoint& other);

/// The same seen from the other side of the surface: normals turned round, so (C1, C2, C3, C4) -> (C1, -C2, -C3, C4).
/// The tangents stay: phi then means the same line on both sides.
OrientedPoint flipped(const OrientedPoint& sample);
Reference flipped(const Reference& reference);
PairFeatures flipped(const PairFeatures& c);

/// C2 <= 0 and C3 >= 0: what holds on every convex body seen from outside; flipped, from inside.
bool isConvex(const PairFeatures& c);

/// The conditions of table II, column "relaxed (C)".
bool normalsParallel(const PairFeatures& c, const VotingRules& rules);
bool pointsCoplanar(const PairFeatures& c, const VotingRules& rules);
bool anglesSymmetric(const PairFeatures& c, const VotingRules& rules);
bool vectorsTriangular(const PairFeatures& c, const VotingRules& rules);

/// Constraint weights: the product of 1 - |deviation| / epsilon over the angles that a condition holds together, at
/// least 0 (sec. II-D; plane: three constraints, AS and VT: one each).
float planeWeight(const PairFeatures& c, float epsilon);
float symmetryWeight(const PairFeatures& c, float epsilon);
float triangleWeight(const PairFeatures& c, float epsilon);

/// R of sphere and cylinder (eq. 6); needs C4 < 1.
float pairRadius(const PairFeatures& c);

/// s_r: from the reference along -n_r to the cone axis (eq. 9); needs C4 < 1.
float coneAxisDistance(const PairFeatures& c);

/// q_i - q_r, parallel to the cone axis (eq. 10), not of unit length; needs C4 < 1.
Vector coneAxis(const OrientedPoint& reference, const OrientedPoint& other, const PairFeatures& c);

/// Angle in [0, pi) of the cylinder axis n_r x n_i against tangent_y in the tangent plane of the reference.
float cylinderAngle(const Reference& reference, const OrientedPoint& other);

/// Weights of a value in units of bins, bin k centred at k + 1/2; beyond the outer centres the outer bin takes all.
LinearSpread spreadLinear(float value_in_bins, int bins);

/// The same on a circle of `bins` bins with bin k centred at k.
LinearSpread spreadCircular(float value_in_bins, int bins);

/// Weights on the ball for an axis of any sign and length > 0: flat in x and y around the pole, linear in polar angle
/// and azimuth elsewhere (sec. II-D).
BallSpread spreadOnBall(const AxisBall& ball, const Vector& axis);

/// Algorithm 1 for the pairs of one reference with all samples. A pair seen from inside votes as its flipped one would.
/// The lists of cells must have room for the votes of all samples, of a cone 4 cells.
void vote(const Reference& reference, const Samples& samples, const VotingRules& rules, Accumulators& accumulators);

/// One way to do this on one kind of processor. All of them cast the votes of vote() but for rounding: where a pair is
/// on a threshold, the decision may differ, and weights are within 1e-4.
struct Kernels {
  const char* name;
  void (*vote)(const Reference&, const Samples&, const VotingRules&, Accumulators&);
};

extern const Kernels kScalar;    ///< the definition
extern const Kernels kPortable;  ///< four lanes of any processor
extern const Kernels kAvx2;      ///< x86-64 with AVX2 and FMA only; not defined for other architectures
extern const Kernels kAvx512;    ///< x86-64 with AVX2, FMA and AVX-512 F, DQ, VL and BW; the same

/// Those that this machine can run, slowest first.
struct Available {
  const Kernels* kernels[4];
  int count;
};
Available availableKernels();

/// The available kernels of that name, the fastest ones for null or an empty text. Throws std::invalid_argument naming
/// the environment variable that the text comes from, the text and the available names.
const Kernels& kernelsNamed(const char* name);

/// What the environment variable PRIMITECT_KERNELS names, or the fastest; read once. Throws as kernelsNamed().
const Kernels& chosenKernels();

}  // namespace primitect::kernels
