// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// What noise across the distance does to a fit: curved surfaces come out too large, slanted ones tilted.
#pragma once

#include "core/point_noise.h"
#include "core/seen_points.h"
#include "primitect/primitives.h"

namespace primitect {

/// Which way measured points stray from where they belong.
enum class NoiseDirection {
  any,        ///< all three axes alike
  along_ray,  ///< of a depth camera at the origin: the depth is wrong, the pixel is not
};

/// The fitted shape less the systematic part of its error. Least squares of distances takes them for independent of
/// where the point is, but E|p - c| = R + s^2 / R around a sphere (s^2 / 2R around a cylinder) with noise s of all
/// axes alike; and along slanted rays a point that is too far is also too far to the side. Both are of second order
/// in the noise, and matter once thousands of points have averaged the first order away.
/// sigma(p): m, standard deviation along the ray, or of each axis; its scale is taken from the residuals.
/// Returns the shape as it is where points or noise do not allow a finite correction.
Shape withoutBias(const Shape& shape, const SeenPoints& inliers, const PointNoise& sigma, NoiseDirection direction);

}  // namespace primitect
