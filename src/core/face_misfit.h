// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Whether points of a plane in a depth image stray from it as noise lets them: a face does, the side of a round thing
// that a plane cuts off does not.
#pragma once

#include <cstdint>

#include "core/frame_memory.h"
#include "core/point_noise.h"
#include "primitect/cloud.h"
#include "primitect/primitives.h"

namespace primitect {

/// How badly a plane fits some points of a cloud: squares of the distances in standard deviations; what is far off
/// counts as three of these.
double misfit(const Cloud& cloud, const List<std::uint32_t>& points, const Plane& plane, const PointNoise& sigma);

/// Square of the distance that three quarters of the points stay below, as a multiple of what it is where a depth
/// camera, which errs along its rays, or rather in z, sees a face. A tenth that is not of the face, like the first
/// pixels of the side of a can that nothing else explains, says nothing against its lid: of one it made the misfit 2.3
/// times that of noise. 0 where there are no points.
double unevenness(const Cloud& cloud, const List<std::uint32_t>& points, const Plane& plane, const PointNoise& sigma);

/// What is more uneven than this is no face. The upper side of a ring, cut off by what is allowed around the plane, has
/// 4 and more, small faces with an edge that nothing explains have up to 1.57.
constexpr double kAsEven = 1.6;

}  // namespace primitect
