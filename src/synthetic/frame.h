// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// One frame of the simulated depth camera.
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

#include "primitect/cloud.h"
#include "primitect/primitives.h"
#include "synthetic/camera.h"
#include "synthetic/noise.h"
#include "synthetic/raycast.h"
#include "synthetic/truth.h"
#include "synthetic/world.h"

namespace primitect::synthetic {

struct FrameParams {
  NoiseParams noise;
  TruthParams truth;
};

/// What the sensor measured, and what was there.
struct Frame {
  std::vector<float> depth;  ///< measured, along z, m; NaN = missing
  std::vector<int> surface;  ///< index in World::surfaces() of what the pixel's ray meets first, or kNoSurface
  Detections truth;          ///< exact shapes; a pixel that was not measured does not count as visible
};

/// Same world, camera, pose, parameters, seed and frame index: same bytes.
/// Throws std::invalid_argument when a noise parameter is out of its range.
Frame renderFrame(const World& world, const PinholeCamera& camera, const Eigen::Isometry3d& world_from_camera,
                  const FrameParams& params, std::uint64_t seed, std::uint64_t frame_index);

/// The organized cloud of a depth image (m) in the camera's optical frame. Reuses the cloud's memory.
/// Throws std::invalid_argument when depth does not have the camera's size.
void cloudFromDepth(const std::vector<float>& depth, const PinholeCamera& camera, const DepthRange& range,
                    Cloud& cloud);

}  // namespace primitect::synthetic
