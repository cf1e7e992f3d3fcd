// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// A table with things on it that somebody wants to see.
#pragma once

#include <Eigen/Geometry>
#include <string>

#include "synthetic/world.h"

namespace primitect::synthetic {

/// How each thing is told; for help and errors.
constexpr const char* kSceneGrammar =
    "none, or things separated by ';', each one of: ball R, can R HEIGHT, cone HALF_ANGLE HEIGHT, box LENGTH WIDTH "
    "HEIGHT, then, in any order: at X Y [Z], turn ANGLE, lying (m, at most 2; deg)";

/// The room and the table of tabletop() with these things on it, as kSceneGrammar says: "can 0.03 0.12 at 0 0.1; ball
/// 0.05 at 0.1 0". They stand on the table, Z above it, or lie, along x before they are turned about the vertical.
/// Without Z their places are on the table; nothing keeps them apart. Throws std::invalid_argument naming the thing and
/// what is expected.
World tableWith(const std::string& things);

/// world_from_camera (optical frame) of a camera at `eye` that looks at `target`, both "X Y Z" (m) in the frame of the
/// world, turned by `roll` (rad) about its view: half a turn, and it is upside down. One that looks straight down has
/// the wall on its upper side. Throws std::invalid_argument naming the text.
Eigen::Isometry3d poseOf(const std::string& eye, const std::string& target, double roll);

}  // namespace primitect::synthetic
