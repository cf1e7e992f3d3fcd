// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Plain loops over structures of arrays that a compiler turns into vectors. Each is written once (*_loops.inc) and
// compiled for every instruction set; all give the same bits: sums have kLanes lanes whatever the width.
#pragma once

#include <cstddef>
#include <cstdint>

#include "kernels/nearest_loops.h"
#include "kernels/window_loops.h"

namespace primitect::kernels {

/// Sums are taken in so many lanes, which are then added up.
constexpr std::size_t kLanes = 16;

/// A shape in float, in the frame of the points it is compared with. What a kind has no use for stays 0.
struct FlatShape {
  enum Kind { plane, sphere, cylinder, cone };
  Kind kind = plane;
  float x = 0, y = 0, z = 0;  ///< point of plane or axis, centre, apex; normalEquations: middle of a cone's circle (m)
  float dx = 0, dy = 0, dz = 0;  ///< normal or axis, of unit length
  float radius = 0;              ///< of sphere and cylinder; normalEquations: of a cone's circle (m)
  float sine = 0, cosine = 0;    ///< of a cone's half angle
};

/// Samples with what they allow; see NoiseModel.
struct JudgedSamples {
  const float *x, *y, *z, *nx, *ny, *nz;
  const float *px, *py, *pz;       ///< m, where the normals are those of the surface
  const float* inverse_tolerance;  ///< 1/m: distance at which nothing is gained
  const float* normal_loss;        ///< what 1 - cos of the normals' angle takes from the gain
  const float* farthest_turn;      ///< 1 - cos from which on a normal belongs to another surface
  const float* held;               ///< best gain that other shapes have; null when no sums are wanted
  float reach;                     ///< up to so many times its tolerance a sample counts, from 1 on against the shape
};

/// Gain of a sample that has nothing to do with the shape.
constexpr float kNoGain = -2.0f;

/// A sample that others hold with this gain does not speak against a shape.
constexpr float kWellExplained = 0.1f;

/// Samples that are judged at once, whole lanes.
constexpr std::size_t kMostGains = 64;

/// Of the samples judged at once.
struct GainSums {
  std::size_t near;     ///< that have a gain
  std::size_t inliers;  ///< with a gain above 0
  float positive;       ///< sum of gains above 0
  float counted;        ///< sum of gains, without those below 0 of samples that others hold well
};

/// Two unit vectors across a shape's direction and each other: the axes that it is turned about.
struct FlatTurn {
  float first_x = 0, first_y = 0, first_z = 0, second_x = 0, second_y = 0, second_z = 0;
};

/// Points to fit to. `count` is a multiple of kLanes: filled up with points of infinite inverse tolerance, which have
/// no weight.
struct FitPoints {
  const float *x, *y, *z;
  const float* inverse_tolerance;  ///< 1/m
  std::size_t count;
};

/// Normals of points that are fitted to, and the inverse of each one's variance about each axis; 0 where that is not
/// known, and for what fills up.
struct FlatNormals {
  const float *x, *y, *z;
  const float* inverse_variance;  ///< 1/rad^2
};

/// How far points are off a plane: sums of squares of their distances, by their tolerances, and of the turns of their
/// normals, by standard deviations about each axis, up to kMostTurnSq each.
struct OffPlane {
  double distances, turns;
};

/// At edges normals are worse than elsewhere.
constexpr float kMostTurnSq = 9.0f;

/// J' W J and -J' W r of a step of least squares with Tukey's biweight; of the hessian the lower triangle. Parameters
/// (m, rad; first, second: along FlatTurn):
///   plane     turn of the normal (2), shift along it
///   sphere    centre (x, y, z), radius
///   cylinder  point along first, second, turn of the axis (2), radius
///   cone      middle of the circle along first, second, turn of the axis about that (2), radius of the circle, half
///             angle
struct NormalEquations {
  double hessian[6][6];
  double right[6];
  double weight;     ///< sum of the weights of the biweight, 1 for a point on the shape
  double curvature;  ///< sum of the derivatives of what they make of the distances, by the distances
};

/// Sums over points p with normals n: of f, f f' (lower triangle) with f = (p, n), and of n n'p.
struct MomentSums {
  static constexpr int kFields = 6;
  double sum[kFields];
  double product[kFields][kFields];
  double tangent[3];
};

/// What lies on the inner side of some planes: products with unit vectors inwards are at least the offsets (m).
struct FlatSide {
  float x, y, z, offset;
};
struct FlatPart {
  const FlatSide* sides;
  std::size_t count;
};

/// least + growth (z - nearest)^2, but at least share * z (m).
struct FlatTolerance {
  float least, growth, nearest, share;
};

/// One for each run of points; radius -1: all of them are missing.
struct Balls {
  float *x, *y, *z, *radius;
};

/// Points are labelled in runs of so many: short enough to lie close together, long enough that what is done once for
/// each costs little. A run has four rows.
constexpr std::size_t kPointsPerRun = 64, kPointsPerRow = 16;
/// Bits of the points in every second row of a run, from the first on.
constexpr std::uint64_t kEverySecondRow = 0x0000ffff0000ffff;
constexpr std::size_t kPointsOfThese = kPointsPerRun / 2;

/// The points of a run, of which some may be NaN. stride: from the first point of a row to that of the next;
/// kPointsPerRow where all follow each other.
struct RunOfPoints {
  const float *x, *y, *z;
  std::size_t stride;
};

/// The ball around a run's points (m), and a bit for each that was measured, the first one lowest; radius -1: none was.
struct RunBall {
  float x, y, z, radius;
  std::uint64_t measured;
};

/// A shape whose points are looked for; without sides, the run lies within its part.
struct LabelTarget {
  const FlatShape* shape;
  FlatPart part;
  std::uint32_t label;
};

/// Distances (m) of points to a surface and its outward unit normals below them.
struct FlatFeet {
  float *distance, *nx, *ny, *nz;
};

struct FlatPlace {
  float x, y, z;
};

/// A place, and how far around it to look (m^2).
struct FlatProbe {
  float x, y, z, reach_sq;
};
/// Weighted sum of the offsets (m) from a place, and of the weights.
struct FlatAround {
  float x, y, z, weight;
};

/// Farthest in x, y and z, nearest and farthest depth (m).
struct PointBounds {
  float farthest, min_z, max_z;
};

/// How many points were measured, and how many of these have z <= 0.
struct MeasuredPoints {
  std::uint32_t count, behind;
};

/// Of the points that a sensor may have seen, and how many these are; infinite the wrong way round where none is.
struct ViewBounds {
  float left, right, top, bottom;  ///< tangents
  std::size_t seen;
};

/// Pixels over x/z and y/z.
struct PixelGrid {
  float left, top, per_width, per_height;  ///< tangents: where the first one begins; 1 over how large they are
  std::int32_t columns, rows;              ///< less than 2^31 pixels
};
constexpr std::uint32_t kNoPixel = 0xffffffffu;

/// A cube of 2^kCellBits cells along each edge.
constexpr int kCellBits = 10;
struct CellCube {
  float low[3];  ///< m
  float cells_per_meter;
};

struct Loops {
  const char* name;  ///< of the instruction set

  /// Robust least squares over the pixels of a window that lie on one surface with its centre.
  WindowPlane (*fitWindow)(const PointImage& image, const WindowTask& task);

  /// Of a window of another size around the same centre: mean of d - a u - b v over its pixels on the plane, by the
  /// tolerance of the fit; c where none is.
  double (*offsetInWindow)(const PointImage& image, const WindowTask& task, const WindowPlane& plane);

  /// Neighbours of a leaf's `count` points among the leaves [begin, end), multiples of kLanes; `keys` holds those known
  /// already, else kNoNeighbor.
  void (*nearest)(const LeafTree& tree, std::size_t leaf, std::size_t count, std::size_t begin, std::size_t end,
                  NearestKeys& keys);

  /// Signed distances (m) of points to a shape.
  void (*distances)(const FlatShape& shape, const float* x, const float* y, const float* z, std::size_t count,
                    float* distance);

  /// Gains of the samples [begin, end), at most kMostGains, into gain[0 ..]; kNoGain where there is none. side: -1
  /// where the surface is seen from inside; scale: of the tolerances, inverse.
  GainSums (*gains)(const FlatShape& shape, float side, float scale, const JudgedSamples& samples, std::size_t begin,
                    std::size_t end, float* gain);

  /// A bit for each of up to 64 values, the first one lowest: set where it is above the limit.
  std::uint64_t (*above)(const float* values, std::size_t count, float limit);

  /// scale: of the tolerances, inverse. A cone is given by the middle of a circle around its axis and that one's
  /// radius, to all other loops by its apex.
  void (*normalEquations)(const FlatShape& shape, const FlatTurn& turn, const FitPoints& points, float scale,
                          NormalEquations& equations);

  /// Points of a depth camera at the origin of `origin` (m), which they are counted from, moved to where only the error
  /// across the surface is left of that of their depth (core/along_rays.h); those whose rays nearly touch the surface,
  /// and what fills up, stay.
  void (*alongRays)(const FlatShape& shape, const FlatPlace& origin, const FitPoints& points, float* x, float* y,
                    float* z);

  /// Sum of 1 - (distance / tolerance)^2 over the points within their tolerance, of every so many-th kLanes of them. Up
  /// to 2^20 points: with more, sums in float lose digits.
  double (*agreement)(const FlatShape& shape, const FitPoints& points, std::size_t every);

  OffPlane (*offPlane)(const FlatShape& plane, const FitPoints& points, const FlatNormals& normals);

  /// fields: x, y, z, nx, ny, nz of count points, a multiple of kLanes; filled up with zeros. once: 1 for each point, 0
  /// for what fills up.
  void (*moments)(const float* const* fields, const float* once, std::size_t count, MomentSums& sums);

  /// Balls around runs of `size` points, of which some may be NaN.
  void (*balls)(const float* x, const float* y, const float* z, std::size_t count, std::size_t size,
                const Balls& result);

  /// How far points lie within the part (m); infinite without sides.
  void (*depths)(const FlatPart& part, const float* x, const float* y, const float* z, std::size_t count, float* depth);

  /// What each depth allows (m).
  void (*tolerances)(const FlatTolerance& tolerance, const float* z, std::size_t count, float* allowed);

  /// Labels the points of a run with the nearest of the shapes, at least one, that is near enough and whose part,
  /// enlarged by what the point is allowed, holds it; 0: none. labels: in rows as the points.
  void (*label)(const FlatTolerance& tolerance, const LabelTarget* targets, std::size_t count,
                const RunOfPoints& points, std::uint32_t* labels);

  /// A bit for each point of a run, the first one lowest: set in every second row where `label` gives none.
  std::uint64_t (*unexplained)(const FlatTolerance& tolerance, const LabelTarget* targets, std::size_t count,
                               const RunOfPoints& points);

  RunBall (*ballOfRun)(const RunOfPoints& points);

  /// A bit for each of kPointsPerRun labels, the first one lowest: set where the next, of one more, is another.
  std::uint64_t (*changes)(const std::uint32_t* labels);

  void (*feet)(const FlatShape& shape, const float* x, const float* y, const float* z, std::size_t count,
               const FlatFeet& feet);

  /// Of `count` points, a multiple of kLanes: filled up with such of weight 0.
  FlatAround (*around)(const FlatProbe& probe, const float* x, const float* y, const float* z, const float* weight,
                       std::size_t count);

  /// Places of the points' cells on the Hilbert curve through the cube's; the outermost cells hold what lies beyond.
  void (*places)(const CellCube& cube, const float* x, const float* y, const float* z, std::size_t count,
                 std::uint32_t* place);

  /// Bytes of `count` points, `step` of them from one to the next, x, y and z first in each: into a list of each.
  void (*takeApart)(const unsigned char* points, std::size_t step, std::size_t count, float* x, float* y, float* z);

  /// Makes NaN of points that are (0, 0, 0), not finite or out of bounds, -NaN of the z of those beyond max_z; counts
  /// the others.
  MeasuredPoints (*dropUnmeasured)(const PointBounds& bounds, float* x, float* y, float* z, std::size_t count);

  /// u = x/z and v = y/z of the points in front of the sensor, no farther aside than `widest`; NaN of all others.
  ViewBounds (*tangents)(const float* x, const float* y, const float* z, std::size_t count, float widest, float* u,
                         float* v);

  /// Row by row; kNoPixel of what lies in none.
  void (*pixelsAt)(const PixelGrid& grid, const float* u, const float* v, std::size_t count, std::uint32_t* pixel);
};

/// For the machine that runs this.
const Loops& loops();

/// All that this machine can run, for tests.
struct LoopsList {
  const Loops* tables[3];
  std::size_t count;
  const Loops* const* begin() const { return tables; }
  const Loops* const* end() const { return tables + count; }
};
LoopsList allLoops();

}  // namespace primitect::kernels
