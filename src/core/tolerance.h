// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// How far a sample may lie from a shape and still belong to it.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/candidate.h"
#include "core/noise.h"
#include "core/samples.h"
#include "primitect/primitives.h"

namespace primitect {

struct Tolerance {
  double distance = 0.0;            ///< m
  double distance_per_depth = 0.0;  ///< above 0: a depth camera; then this share of z, or three times its noise
  double cos_angle = 1.0;           ///< between the normals
  double scale = 1.0;               ///< of what the depth gives

  double distanceAt(const Vec3& point) const {
    if (distance_per_depth <= 0.0) return distance;
    return scale * std::max(3.0 * axialNoise(point.z()), distance_per_depth * point.z());
  }

  /// The same for distances `factor` times as large.
  Tolerance scaled(double factor) const {
    Tolerance result = *this;
    result.distance *= factor;
    result.scale *= factor;
    return result;
  }
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
