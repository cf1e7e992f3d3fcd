// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Pixels between two surfaces, of none of them: a camera that mixes what it sees at an edge measures a depth between.
#pragma once

#include <cstdint>

#include "core/image_rays.h"
#include "primitect/cloud.h"
#include "primitect/primitives.h"

namespace primitect {

/// An image, and how it measures.
struct ImageOfCamera {
  const Cloud& image;
  const ImageRays& rays;
  double noise_scale;  ///< times axialNoise()
  double share;        ///< of usual windows (shareOfUsualWindows)
};

/// A surface with this point and normal is seen at less than 12 deg and a few pixels wide, with something else measured
/// beyond its near and its far side: such pixels around a ball look like a sharp cone, along the edge of a box like a
/// plane. Of images without known rays nothing is told.
bool fliesBetween(const ImageOfCamera& camera, std::uint32_t pixel, const Vec3& point, const Vec3& normal);

}  // namespace primitect
