// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Renders a world: the exact depth and the surface seen by every pixel.
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "synthetic/camera.h"
#include "synthetic/world.h"

namespace primitect::synthetic {

constexpr int kNoSurface = -1;

/// One image, row by row.
struct Rendering {
  std::vector<float> depth;  ///< along z of the optical frame, m; NaN where nothing is hit
  std::vector<int> surface;  ///< index in World::surfaces(), or kNoSurface
};

/// Exact depth of a world seen from a camera that is outside of every body. Memory of the rendering is reused.
void render(const World& world, const PinholeCamera& camera, const Eigen::Isometry3d& world_from_camera,
            Rendering& rendering);

}  // namespace primitect::synthetic
