// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// How much of a shape was seen.
#pragma once

#include "core/seen_points.h"
#include "primitect/primitives.h"

namespace primitect {

/// What the points of a surface are dense by.
enum class Density {
  of_surface,  ///< equally dense on it
  of_pixels    ///< in the image of a camera at the origin: of a plane seen at a slant, the far part has few of them
};

/// Observed share of: sphere: the whole area; cylinder and cone: the full turn; plane: its hull (below 1: holes). In
/// [0, 1]; 0 without inliers. The same for convex and concave shapes. extent: of the same inliers.
float measureCoverage(const Shape& shape, const Extent& extent, const SeenPoints& inliers,
                      Density density = Density::of_surface);

/// Observed part of the turn around an axis (rad, in [0, 2 pi]); several parts are added up. Of a cone, the points near
/// the apex do not count: their direction from the axis is mostly noise. 2 pi for planes and spheres.
double observedArc(const Shape& shape, const Extent& extent, const SeenPoints& inliers);

}  // namespace primitect
