// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Render, add noise, write down the truth.
#include "synthetic/frame.h"

#include <cmath>
#include <stdexcept>
#include <string>

namespace primitect::synthetic {

Frame renderFrame(const World& world, const PinholeCamera& camera, const Eigen::Isometry3d& world_from_camera,
                  const FrameParams& params, std::uint64_t seed, std::uint64_t frame_index) {
  Rendering rendering;
  render(world, camera, world_from_camera, rendering);
  Frame frame;
  frame.depth = rendering.depth;
  addNoise(params.noise, camera, seed, frame_index, frame.depth);
  // The truth has exact depth, but only where the sensor saw something.
  for (std::size_t i = 0; i < frame.depth.size(); ++i) {
    if (std::isnan(frame.depth[i])) rendering.depth[i] = kMissing;
  }
  frame.truth = truthOf(world, camera, world_from_camera, rendering, params.truth);
  frame.surface = std::move(rendering.surface);
  return frame;
}

void cloudFromDepth(const std::vector<float>& depth, const PinholeCamera& camera, const DepthRange& range,
                    Cloud& cloud) {
  if (depth.size() != camera.pixelCount()) {
    throw std::invalid_argument("cloudFromDepth: " + std::to_string(depth.size()) + " depths for a camera of " +
                                std::to_string(camera.width) + " x " + std::to_string(camera.height) + " pixels");
  }
  cloud.reset(static_cast<std::uint32_t>(camera.width), static_cast<std::uint32_t>(camera.height), false);
  std::size_t i = 0;
  for (int v = 0; v < camera.height; ++v) {
    for (int u = 0; u < camera.width; ++u, ++i) {
      const Vec3 point = camera.ray(u, v) * static_cast<double>(depth[i]);
      cloud.setPoint(i, static_cast<float>(point.x()), static_cast<float>(point.y()), depth[i], range);
    }
  }
}

}  // namespace primitect::synthetic
