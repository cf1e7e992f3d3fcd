// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The exact answer for a rendered frame, in the detector's own words.
#pragma once

#include <Eigen/Geometry>
#include <cstdint>

#include "primitect/cloud.h"
#include "primitect/primitives.h"
#include "synthetic/camera.h"
#include "synthetic/raycast.h"
#include "synthetic/world.h"

namespace primitect::synthetic {

/// Which surfaces count as there to be found.
struct TruthParams {
  DepthRange range{0.1f, 2.0f};    ///< the detector's depth cut; pixels outside do not count
  std::uint32_t min_pixels = 900;  ///< a surface with fewer visible pixels is left out
};

/// One detection for each surface with enough visible pixels, in the order of their index, in the camera's frame.
/// Surfaces that are no primitive are left out, though their pixels count as points used.
/// Plane normals point to the sensor, cone axes from the apex into the body. The extent is that of the visible part
/// within the range; for planes the smallest rectangle around the hull, x along its longer side. inlier_count
/// is the number of visible pixels, confidence 1, rms_error 0. Missing pixels (NaN) in the rendering do not count.
/// If surface_of_item is given, it gets the index of the surface of each detection.
Detections truthOf(const World& world, const PinholeCamera& camera, const Eigen::Isometry3d& world_from_camera,
                   const Rendering& rendering, const TruthParams& params, std::vector<int>* surface_of_item = nullptr);

}  // namespace primitect::synthetic
