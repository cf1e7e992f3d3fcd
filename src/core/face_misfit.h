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

/// What the misfit is in the mean where a depth camera sees a face with this normal: it errs along its rays, or rather
/// in z.
double misfitByNoise(const Cloud& cloud, const List<std::uint32_t>& points, const Vec3& normal);

/// With a misfit of so many times what noise makes of it, and more, it is no face. The upper side of a ring, cut off by
/// what is allowed around the plane, has 1.6 to 1.9 times as much, faces up to 1.5 times.
constexpr double kAsEven = 1.6;

}  // namespace primitect
