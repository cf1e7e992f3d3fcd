// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Whether a surface is where a shape says it is: clutter is in tatters where a tube is whole.
#pragma once

#include <cstdint>
#include <optional>

#include "core/axis_extent.h"
#include "core/frame_memory.h"
#include "core/image_sight.h"
#include "primitect/primitives.h"

namespace primitect {

/// How much of a cylinder or cone is seen, [0, 1].
struct SeenShare {
  double all = 1.0;  ///< of what was observed of it
  /// Along the axis, from the extent's origin: beyond it is hardly seen. It has no end where the extent has its own;
  /// none where the image does not tell of such an end.
  std::optional<AxisPart> part;
  double in_part = 1.0;  ///< of that part
};

/// Of places all over the observed part of a cylinder or cone, the share at which the image has a point on the surface.
/// A ninth of them is asked where that settles that nearly all of it is seen, else more. Blots with the surface on both
/// sides count a quarter, other holes half. Not asked are places that something nearer hides, with the shadow beside
/// it, single missing pixels, those between which and the border of the image nothing is measured, those at the limb,
/// and those at a bound of the depth. pixels: points of the cloud on the shape. 1 of planes and spheres, whose extent
/// does not tell where they end, of clouds that are no image, and where there are too few places to tell.
SeenShare seenShare(const Detection& detection, const List<std::uint32_t>& pixels, const AskedImage& image);

/// Whether any confidence is left in the shape by this share, or by that of one part along the axis with a fifth of the
/// places or more: the shape may lead through several things, with gaps between them. True where nothing tells, as
/// above.
bool isSeenSomewhere(const Detection& detection, const List<std::uint32_t>& pixels, const AskedImage& image);

/// Of the same places, the share at which the image shows what lies clearly behind the surface, also beyond the far
/// bound of the depth; 0 where there are too few to tell, and where seenShare() is 1 for all shapes. What is a little
/// nearer, or a hole, is not behind.
double behindShare(const Detection& detection, const List<std::uint32_t>& pixels, const AskedImage& image);

/// What is left of the confidence in a shape of which only this share is seen. Real tubes and cups of recorded frames
/// are seen to 0.9 and more in spite of the holes of glossy surfaces; what was taken for one in clutter seldom to 0.85.
double trustInShare(double seen_share);

}  // namespace primitect
