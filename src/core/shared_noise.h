// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Whether neighbouring points err alike, as those of real depth cameras do.
#pragma once

#include "core/point_noise.h"
#include "core/seen_points.h"
#include "primitect/primitives.h"

namespace primitect {

/// How many of these points share one deviation from the fitted shape, at least 1: the number by which a covariance
/// from independent points has to be multiplied. From the sums of residuals over some thirty cells of the surface,
/// which grow like the square root of the number of points only where the noise is independent; 1 unless chance is
/// ruled out. What is shared over larger parts of the surface goes into the fit and cannot be seen.
double measureSharedNoise(const Shape& shape, const SeenPoints& inliers, const PointNoise& sigma);

}  // namespace primitect
