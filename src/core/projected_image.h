// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The image that an unorganized cloud of one depth camera once was: filtered or shuffled clouds get it back.
#pragma once

#include <cstdint>
#include <optional>

#include "core/frame_memory.h"
#include "primitect/cloud.h"

namespace primitect {

/// A cloud as an image over x/z and y/z.
struct ProjectedImage {
  Cloud image;
  List<std::uint32_t> pixel;  ///< of each point of the cloud; of missing points: 0
};

/// Pixels as large as the points are apart; of two points in a pixel the image holds the nearer one. Nothing when the
/// cloud is organized, when points lie beside or behind the sensor, or when many pixels hold points of very different
/// depth: then it was not seen from the origin.
std::optional<ProjectedImage> projectedImage(const Cloud& cloud);

}  // namespace primitect
