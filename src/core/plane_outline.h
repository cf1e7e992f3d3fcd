// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The part of a plane that was seen.
#pragma once

#include <vector>

#include "core/seen_points.h"
#include "primitect/primitives.h"

namespace primitect {

/// Its outline is around all large parts: something in front may hide what lies between them. A few points of other
/// objects that happen to lie in the plane do not stretch it. Parts are cells of three mean spacings that touch. At
/// least one inlier; outermost: more of them, which the outline is to hold unless they lie apart from all others;
/// outline: whose memory the hull is to have.
Extent outlineOf(const Plane& plane, const SeenPoints& inliers, const SeenPoints& outermost, std::vector<Vec3> outline);

}  // namespace primitect
