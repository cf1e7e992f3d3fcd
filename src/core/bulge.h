// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// What curves along its axis, too, as a barrel or a slice of a bowl does, is neither a cylinder nor a cone.
#pragma once

#include "core/point_noise.h"
#include "core/seen_points.h"
#include "primitect/primitives.h"

namespace primitect {

/// Curvature along the axis over that around it: 0 of a cylinder and a cone, 1 of a ball, less than 0 of a waist.
struct Bulge {
  double least = 0.0, most = 1.0;
};

/// How much a cylinder or a cone that was fitted to these points bulges between the ends of its extent, by the second
/// Legendre polynomial along the axis in the distances of the points. It may be half a standard deviation of what is
/// left of them less or more, or of the least noise (m) where that is more: so much chance may do, or a camera that
/// bends what it sees. Of other kinds, and of fewer than eight points between the ends, it may be anything.
Bulge bulgeOf(const Shape& shape, const SeenPoints& points, const Extent& extent, const PointNoise& sigma);

/// What is left of the confidence in a shape that bulges by so much, [0, 1].
double trustInStraightSide(const Bulge& bulge);

/// Whether it bulges too much for a cylinder or a cone, and may be a slice of a ball.
bool mayBeSliceOfBall(const Bulge& bulge);

}  // namespace primitect
