// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Things of one radius on one axis, which pass for one long tube.
#pragma once

#include <cstdint>

#include "core/axis_extent.h"
#include "core/frame_memory.h"
#include "core/seen_share.h"
#include "primitect/cloud.h"
#include "primitect/primitives.h"

namespace primitect {

/// The parts of a cylinder or cone, in rising order, between which the image of a depth camera shows what lies behind
/// where the surface would be. A gap that something hides parts nothing: a pipe goes on behind a post. pixels: its
/// points, in any order. One part where there is no such gap, none without points.
List<AxisPart> partsOfTube(const Detection& tube, const List<std::uint32_t>& pixels, const AskedImage& image);

/// Where the point lies along the tube's axis (m, from the extent's origin).
inline float heightOn(const Detection& tube, const Cloud& cloud, std::uint32_t i) {
  const Vec3 axis = tube.extent.rotation.col(2), &from = tube.extent.origin;
  return static_cast<float>(axis.dot(cloud.point(i) - from));
}

}  // namespace primitect
