// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Whether neighbouring points err alike, as those of real depth cameras do.
#pragma once

#include "core/point_noise.h"
#include "core/seen_points.h"
#include "primitect/primitives.h"

namespace primitect {

/// How many points share one deviation from the surface, at least 1: the number by which a covariance from independent
/// points has to be multiplied.
struct SharedNoise {
  double shown = 1.0;  ///< as cells of the surface show it: too few where they are hardly larger than what is shared
  double all = 1.0;    ///< what it would be in large cells; no more than a cell holds, still too few of larger grains
};

/// Of these points of a fitted shape: from the sums of residuals over some thirty cells of the surface, which grow like
/// the square root of the number of points only where the noise is independent; 1 unless chance is ruled out. What is
/// shared over larger parts of the surface goes into the fit and cannot be seen.
SharedNoise measureSharedNoise(const Shape& shape, const SeenPoints& inliers, const PointNoise& sigma);

}  // namespace primitect
