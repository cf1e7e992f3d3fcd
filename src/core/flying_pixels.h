// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Pixels between two surfaces, of none of them: a camera that mixes what it sees at an edge measures a depth between.
#pragma once

#include <cstdint>

#include "core/image_rays.h"
#include "primitect/cloud.h"
#include "primitect/primitives.h"

namespace primitect {

/// A surface seen at less than 12 deg that is a few pixels wide from its near to its far side: such pixels around a
/// ball look like a sharp cone, along the edge of a box like a plane. The normal has been measured at this pixel;
/// share: of usual windows (shareOfUsualWindows). Of images without known rays nothing is told.
bool fliesBetween(const Cloud& image, const ImageRays& rays, std::uint32_t pixel, const Vec3& normal, double share);

}  // namespace primitect
