// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// A table with things on it, different for every seed, and a camera that moves slowly around it.
#pragma once

#include <Eigen/Geometry>
#include <cstdint>

#include "synthetic/world.h"

namespace primitect::synthetic {

/// The world frame: x from the camera towards the wall, z up, the floor at z = 0, the table's centre at x = y = 0.
constexpr double kTableHeight = 0.75;
constexpr double kTableHalfX = 0.65, kTableHalfY = 0.75;  ///< m, half of its sides

/// Floor, wall and table.
World emptyRoom();

/// The same, and on the table 2-3 spheres, 2-3 cylinders (standing or lying), 1-2 cones (half angle 10 to
/// 35 deg, pointed or cut off, standing or lying) and 1-2 boxes, radii 25 to 90 mm. Objects stand on the table, do not
/// touch each other, and from every cameraPose() each is in view as a whole, the curved face of each curved one
/// with more than 900 pixels of the default PinholeCamera. Floor and wall are beyond 2 m from there.
World tabletop(std::uint64_t seed);

/// world_from_camera (optical frame) at a time: a swing of +-20 deg around the table from about 1 m, period 24 s.
Eigen::Isometry3d cameraPose(double seconds);

}  // namespace primitect::synthetic
