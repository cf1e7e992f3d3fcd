// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The points of one top, where a plane leads over several things.
#pragma once

#include <cstdint>

#include "core/frame_memory.h"
#include "core/point_noise.h"
#include "primitect/cloud.h"
#include "primitect/primitives.h"

namespace primitect {

/// Takes out of a plane's points those at another height than its main piece, where the closer look had too few samples
/// to take the plane apart (plane_parts.h). A connected piece that lies level about as well as it lies in the plane is
/// a top; then the plane is tilted only because it reaches to pieces a little higher or lower, or to clutter. points:
/// rising indices in the cloud; level: the normal of what things stand on. Returns, rising, those of the piece with the
/// most level points and of all others at its height; all points where there is but one piece, or where the plane
/// really is tilted.
List<std::uint32_t> levelTop(const Cloud& cloud, const Plane& plane, const Vec3& level, const PointNoise& sigma,
                             const List<std::uint32_t>& points);

}  // namespace primitect
