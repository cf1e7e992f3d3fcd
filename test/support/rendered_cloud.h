// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// What the simulated camera sees of a world, as a cloud.
#pragma once

#include <cmath>
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

/// Before a wall 3 m away, of which the cut at 2 m leaves nothing.
inline Cloud cloudBeforeFarWall(synthetic::World world, std::uint64_t seed) {
  world.add("wall", synthetic::Sheet{4.0, 4.0}, Eigen::Translation3d(0.0, 0.0, 3.0) * Eigen::Isometry3d::Identity());
  return renderedCloud(world, {}, seed);
}

/// Of a table so far (m) in front of a camera that looks down by this angle (rad): x to the right, z up.
inline Eigen::Isometry3d tableBeforeCamera(double distance, double down) {
  const Vec3 up(0.0, -std::cos(down), -std::sin(down));
  Eigen::Isometry3d table = Eigen::Isometry3d::Identity();
  table.linear() << Vec3::UnitX(), up.cross(Vec3::UnitX()), up;
  table.translation() = distance * Vec3::UnitZ();
  return table;
}

}  // namespace primitect::test
