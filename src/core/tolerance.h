// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// How far a sample may lie from a shape and still belong to it.
#pragma once

#include <cmath>
#include <limits>

#include "core/candidate.h"
#include "core/noise.h"
#include "core/samples.h"
#include "primitect/primitives.h"

namespace primitect {

struct Tolerance {
  NoiseModel noise;
  double cos_angle = 1.0;                 ///< between the normals
  double deviations = kInlierDeviations;  ///< of the noise

  double distanceAt(const Vec3& point) const { return deviations * noise.at(point); }

  /// The same for distances `factor` times as large.
  Tolerance scaled(double factor) const { return {noise, cos_angle, factor * deviations}; }
};

/// |distance| of the sample to the shape if it can be its inlier, else infinity.
inline double inlierDistance(const Shape& shape, bool concave, const Samples& samples, std::size_t i,
                             const Tolerance& tolerance) {
  constexpr double kNone = std::numeric_limits<double>::infinity();
  const Vec3 point = samples.point(i);
  const double away = std::abs(distance(shape, point));
  if (!(away < tolerance.distanceAt(point))) return kNone;
  return samples.normal(i).dot(seenNormalAt(shape, concave, point)) > tolerance.cos_angle ? away : kNone;
}

}  // namespace primitect
