// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// A narrow band of a ball is as well a ring: the rim of a pot.
#pragma once

#include "primitect/primitives.h"

namespace primitect {

/// How points lie on a ball, in the plane that touches it in their middle.
struct BallBand {
  double elongation;  ///< the longer spread over the shorter one
  double rise;        ///< m, by which the surface curves away across the shorter one
};

/// Of points with this mean (m), not the ball's centre, and this scatter about it, E[p p'] (m^2). Of points in a line
/// the elongation is infinite.
BallBand bandOn(const Sphere& ball, const Vec3& mean, const Eigen::Matrix3d& scatter);

}  // namespace primitect
