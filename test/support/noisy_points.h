// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Points as a sensor measures them: a millimetre off, with normals that are turned.
#pragma once

#include <vector>

#include "test/support/exact_shapes.h"

namespace primitect::test {

/// Of points (m, one standard deviation), where a test has no reason for another.
constexpr double kNoise = 0.001;

/// Measured with noise of all axes alike (m, one standard deviation each) and normals turned about two axes (rad each).
inline std::vector<SurfacePoint> measured(std::vector<SurfacePoint> points, double noise, double turn, Random& random) {
  for (SurfacePoint& p : points) {
    const Vec3 x = p.normal.unitOrthogonal(), y = p.normal.cross(x);
    for (int axis = 0; axis < 3; ++axis) p.point[axis] += noise * random.gaussian();
    const double along_x = turn * random.gaussian(), along_y = turn * random.gaussian();
    p.normal = (p.normal + along_x * x + along_y * y).normalized();
  }
  return points;
}

}  // namespace primitect::test
