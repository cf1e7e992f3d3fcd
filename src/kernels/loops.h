// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Plain loops over structures of arrays that a compiler turns into vectors. Each is written once (loops_*.inc) and
// compiled for every instruction set; all give the same bits: sums have kLanes lanes whatever the width.
#pragma once

#include <cstddef>

namespace primitect::kernels {

/// Sums are taken in so many lanes, which are then added up.
constexpr std::size_t kLanes = 16;

/// A shape in float, in the frame of the points it is compared with. What a kind has no use for stays 0.
struct FlatShape {
  enum Kind { plane, sphere, cylinder, cone };
  Kind kind = plane;
  float x = 0, y = 0, z = 0;     ///< point of plane or axis, centre, apex (m)
  float dx = 0, dy = 0, dz = 0;  ///< normal or axis, of unit length
  float radius = 0;              ///< of sphere and cylinder (m)
  float sine = 0, cosine = 0;    ///< of a cone's half angle
};

/// Samples with what they allow; see NoiseModel.
struct JudgedSamples {
  const float *x, *y, *z, *nx, *ny, *nz;
  const float* inverse_tolerance;  ///< 1/m: distance at which nothing is gained
  const float* normal_loss;        ///< what 1 - cos of the normals' angle takes from the gain
  const float* farthest_turn;      ///< 1 - cos from which on a normal belongs to another surface
};

/// Gain of a sample that has nothing to do with the shape.
constexpr float kNoGain = -2.0f;

struct Loops {
  const char* name;  ///< of the instruction set

  /// Signed distances (m) of points to a shape.
  void (*distances)(const FlatShape& shape, const float* x, const float* y, const float* z, std::size_t count,
                    float* distance);

  /// Gains of the samples [begin, end) into gain[0 ..]; kNoGain where there is none. side: -1 where the surface is seen
  /// from inside; scale: of the tolerances, inverse.
  void (*gains)(const FlatShape& shape, float side, float scale, const JudgedSamples& samples, std::size_t begin,
                std::size_t end, float* gain);
};

/// For the machine that runs this.
const Loops& loops();

}  // namespace primitect::kernels
