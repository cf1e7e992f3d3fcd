// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Where the camera of a list was whose order tells nothing: averaged by a voxel grid, or shuffled, in whatever frame.
#pragma once

#include <Eigen/Geometry>
#include <optional>

#include "primitect/cloud.h"

namespace primitect {

/// Nearly all points are ahead along z, and none before another one: a camera at the origin may have seen them.
bool mayBeSeenFromOrigin(const Cloud& list);

/// The camera's optical frame (z to the middle of the points, y down to the plane) in the frame of the points. Of a
/// table or a floor it does not see what lies behind the things that stand there, seen from the camera: as a lamp it
/// would cast their shadows. Of the places above the plane that most of the points lie in it is the one whose shadows
/// are the holes that the plane has; to some centimetres, along the line of sight to a tenth of the distance.
///
/// Nothing where a camera at the origin may have seen them, no plane holds a third of the points, little stands on it,
/// no place makes its holes well, from there points would be hidden, or the origin makes the holes about as well.
std::optional<Eigen::Isometry3d> findCameraByShadows(const Cloud& list);

}  // namespace primitect
