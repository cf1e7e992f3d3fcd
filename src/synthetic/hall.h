// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// A hall as a robot sees it that drives through: large things on its floor, many of them cut by the image's border.
#pragma once

#include <Eigen/Geometry>
#include <cstdint>

#include "synthetic/world.h"

namespace primitect::synthetic {

/// Floor, two walls, and up to 9 things on the floor: traffic cones on square feet ("foot"), balls, open bins, pillars,
/// lying tubes, crates, ellipsoids and lumps, 8 cm to 1 m large, pillars 2.6 m high. They do not intersect. World
/// frame: z up, the floor at z = 0.
World hall(std::uint64_t seed);

/// world_from_camera (optical frame): .3 to 1.2 m above the floor and before all things, looking ahead and down by 5 to
/// 35 deg.
Eigen::Isometry3d hallPose(std::uint64_t seed);

}  // namespace primitect::synthetic
