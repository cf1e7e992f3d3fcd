// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// What is nearly a ball, like an egg, fits one worse than the noise of a depth camera allows.
#pragma once

#include "core/point_noise.h"
#include "core/seen_points.h"
#include "primitect/primitives.h"

namespace primitect {

/// What is left of the confidence in a shape that was fitted to these points of a depth camera, [0, 1], by how far they
/// stray from it: rms_error (m), that of rmsDistance(). Of balls only: the side that is seen of an oval tube, axes 1
/// to 1.6, strays by no more than that of a round one.
double trustInFit(const Shape& shape, double rms_error, const SeenPoints& points, const PointNoise& sigma);

}  // namespace primitect
