// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Normals of the samples: the cloud's own, or a plane fit to the image window or to the nearest neighbours.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/neighbors.h"
#include "core/samples.h"
#include "primitect/cloud.h"
#include "primitect/params.h"

namespace primitect {

/// Fills the normals of the samples, from the cloud where it brings any that are usable. The tree of neighbours is
/// built when it is needed and not there yet. Estimated normals point towards the sensor; where none can be had it
/// stays missing, and that sample does not vote.
void estimateNormals(const Cloud& cloud, const Params& params, std::unique_ptr<NeighborSearch>& neighbors,
                     Samples& samples);

/// Normal at a pixel of an organized cloud, towards the sensor: robust plane fit of 1/z over x/z and y/z in a window of
/// (2 half_width + 1)^2 pixels. In these coordinates a plane is linear and the noise of a depth camera even.
/// Nothing when too few pixels of the window lie on one surface with the centre. Needs z > 0.
std::optional<Vec3> windowNormal(const Cloud& cloud, std::uint32_t pixel, int half_width);

/// Normal of the plane through the points (least squares), sign not known; nothing when they do not span a plane.
std::optional<Vec3> planeNormal(const Cloud& cloud, const std::vector<std::uint32_t>& points);

}  // namespace primitect
