// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// What the simulated camera sees of a world, as a cloud.
#pragma once

#include <cstdint>

#include "primitect/cloud.h"
#include "synthetic/frame.h"

namespace primitect::test {

/// By the default camera from this pose, with the first frame's noise of this seed.
inline Cloud renderedCloud(const synthetic::World& world, const synthetic::FrameParams& params, std::uint64_t seed,
                           const Eigen::Isometry3d& world_from_camera = Eigen::Isometry3d::Identity()) {
  const synthetic::PinholeCamera camera;
  Cloud cloud;
  cloudFromDepth(renderFrame(world, camera, world_from_camera, params, seed, 0).depth, camera, params.truth.range,
                 cloud);
  return cloud;
}

}  // namespace primitect::test
