// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// What is nearly a ball, like an egg, fits one worse than the noise of a depth camera allows, and not everywhere alike.
#pragma once

#include "core/point_noise.h"
#include "core/seen_points.h"
#include "primitect/primitives.h"

namespace primitect {

/// What is left of the confidence in a shape that was fitted to these points of a depth camera, [0, 1], by how far they
/// stray from it: rms_error (m), that of rmsDistance(). Of balls only: the side that is seen of an oval tube, axes 1
/// to 1.6, strays by no more than that of a round one.
double trustInFit(const Shape& shape, double rms_error, const SeenPoints& points, const PointNoise& sigma);

/// Variance of the distances to a ball from one of sixteen parts of what is seen of it to the next, as a share of that
/// within the parts, or of the square of the least noise (m) where that is more: 0, up to chance, of a ball, whatever
/// the noise. A part is a quarter of the turn around where most is seen, in one of four rings of as many points. 0
/// where fewer than six of them have eight points.
double unevennessOf(const Sphere& ball, const SeenPoints& seen, double least_noise);

/// What is left of the confidence in a shape that was fitted to these points, [0, 1], by its unevenness: where noise
/// was measured in the cloud itself, or is less than that of usual depth cameras, what is nearly a ball passes for a
/// noisy one. Full of other kinds, and where that is not told.
double trustInEvenness(const Shape& shape, const SeenPoints& points, const PointNoise& sigma, bool of_depth_camera);

}  // namespace primitect
