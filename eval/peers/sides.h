// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Libraries leave signs open: planes turned to where their points look, cones opened to where their points are.
#pragma once

#include <cmath>

#include "primitect/primitives.h"

namespace primitect::eval {

/// The plane with its normal on the side of the mean normal of its points.
inline Plane turnedTo(Plane plane, const Vec3& mean_normal) {
  if (plane.normal.dot(mean_normal) < 0.0) plane.normal = -plane.normal;
  return plane;
}

/// The cone with its axis from the apex towards the mean of its points, and the half angle in [0, pi/2].
inline Cone openedTo(Cone cone, const Vec3& mean_point) {
  if (cone.axis.dot(mean_point - cone.apex) < 0.0) cone.axis = -cone.axis;
  cone.half_angle = std::abs(cone.half_angle);
  if (cone.half_angle > M_PI / 2) cone.half_angle = M_PI - cone.half_angle;
  return cone;
}

}  // namespace primitect::eval
