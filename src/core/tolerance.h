// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// How far a sample may lie from a shape and still belong to it.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/samples.h"
#include "primitect/primitives.h"

namespace primitect {

/// Axial noise of structured-light cameras (m, one standard deviation) at depth z (Nguyen et al., 3DIMPVT 2012).
inline double axialNoise(double z) { return 0.0012 + 0.0019 * (z - 0.4) * (z - 0.4); }

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
inline double inlierDistance(const Shape& shape, const Samples& samples, std::size_t i, const Tolerance& tolerance) {
  constexpr double kNone = std::numeric_limits<double>::infinity();
  const Vec3 point = samples.point(i);
  const double away = std::abs(distance(shape, point));
  if (!(away < tolerance.distanceAt(point))) return kNone;
  return samples.normal(i).dot(normalAt(shape, point)) > tolerance.cos_angle ? away : kNone;
}

}  // namespace primitect
