// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Where the image shows that a cylinder ends: a pipe goes over into a bend, a gas bottle into its dome, and the floor
// touches the limb of what lies on it.
#pragma once

#include <optional>

#include "core/axis_extent.h"
#include "core/image_sight.h"
#include "primitect/primitives.h"

namespace primitect {

/// Rings of a cylinder are looked at from either end of its extent, where they face the sensor. An end lies before the
/// rings of which less than two thirds are on the surface, where these are two pixels and a twenty-fourth of the length
/// at least; no more than three tenths of it are left out at an end. A ring of which fewer than five places tell, as
/// the rest is hidden or missing, is one of the cylinder's. Returns what is left along the axis, from the extent's
/// origin (m), without an end where the extent has its own; nothing where it has both.
std::optional<AxisPart> seenEnds(const Cylinder& cylinder, bool concave, const Extent& extent, const AskedImage& image);

}  // namespace primitect
