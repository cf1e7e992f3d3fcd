// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// A narrow plane that bends across is the side of a thin tube.
#pragma once

#include <optional>

#include "core/seen_points.h"
#include "primitect/primitives.h"

namespace primitect {

/// Whether a plane of this extent is much longer than wide.
bool isStrip(const Extent& extent);

/// How the points of a plane bend across the shorter side of its extent.
struct Bend {
  double turn;        ///< rad, of the normal from one side to the other; positive: convex, seen from where it points to
  double deviations;  ///< the same in its standard deviations
};

/// Least squares of the heights above the plane, quadratic across; of points that are more than one line.
Bend bendAcross(const Plane& plane, const Extent& extent, const SeenPoints& points);

/// The tube of which a strip that was taken for a plane may be the side, as its bend tells; nothing where it is no
/// strip, does not bend far enough to tell, or is hollow. Windows of pixels that normals are fitted to are as wide as
/// such a tube: its samples all have nearly the same normal, but its points are not in a plane.
std::optional<Cylinder> tubeOf(const Plane& plane, const Extent& extent, const SeenPoints& points);

/// What is left of the confidence in a plane, [0, 1]: nothing in a strip that bends, whatever it is.
double trustInFlat(const Plane& plane, const Extent& extent, const SeenPoints& points);

}  // namespace primitect
