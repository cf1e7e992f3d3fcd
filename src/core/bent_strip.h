// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// A narrow plane that bends across is the side of a thin tube, or of a bar.
#pragma once

#include "core/seen_points.h"
#include "primitect/primitives.h"

namespace primitect {

/// How the points of a plane bend across the shorter side of its extent.
struct Bend {
  double turn;        ///< rad, of the normal from one side to the other; positive: convex, seen from where it points to
  double deviations;  ///< the same in its standard deviations
};

/// Least squares of the heights above the plane, quadratic across; 0 where the points do not tell, as two lines.
Bend bendAcross(const Plane& plane, const Extent& extent, const SeenPoints& points);

/// What is left of the confidence in a plane, [0, 1]: nothing in a strip that bends, whatever it is. Windows of pixels
/// that normals are fitted to are as wide as a thin tube: its samples all have nearly the same normal, but its points
/// are not in a plane.
double trustInFlat(const Plane& plane, const Extent& extent, const SeenPoints& points);

}  // namespace primitect
