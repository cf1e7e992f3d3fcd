// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The part of a shape that was seen, from its inliers.
#pragma once

#include <vector>

#include "core/axis_extent.h"
#include "core/seen_points.h"
#include "primitect/primitives.h"

namespace primitect {

/// Extent of the part where the inliers lie (m). A few stragglers do not stretch it: along an axis the outer 1 % at
/// either end are left out. outermost: more of the inliers, which a plane's outline is to hold unless they lie apart
/// from all others. outline: whose memory a plane's hull is to have.
Extent measureExtent(const Shape& shape, const SeenPoints& inliers, const SeenPoints& outermost,
                     std::vector<Vec3> outline);
Extent measureExtent(const Shape& shape, const SeenPoints& inliers, std::vector<Vec3> outline = {});

/// The same of a cylinder or a cone to its ends (axis_extent.h). Of other kinds the extent stays as it is.
void measureToTheEnds(const Shape& shape, const SeenPoints& inliers, Extent& extent);

/// The same shape with a sign of its axis that does not flip from frame to frame: a cylinder's points up in the image
/// (y < 0), to the right where it lies within 5 deg (x > 0), else away (z > 0).
Shape canonical(const Shape& shape);

}  // namespace primitect
