// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Where the camera of a list was whose order tells nothing: averaged by a voxel grid, or shuffled, in whatever frame.
#pragma once

#include <Eigen/Geometry>
#include <optional>

#include "primitect/cloud.h"

namespace primitect {

/// It is a list of 500 points and more without normals (with them it may be anything: what was scanned, a model, a
/// map), and no camera at the origin that looks along z has seen them all: it may be worth to look at shadows.
bool mayTellByShadows(const Cloud& list);

/// The camera's optical frame (z to the middle of the plane, y down to it) in the frame of the points. Of a table or a
/// floor it does not see what lies behind the things that stand there, seen from the camera: as a lamp it would cast
/// their shadows. Of the places up to 2.6 m from one of the two planes that most of the points lie in it is the one
/// whose shadows are the holes that the plane has, or the origin, if that is about as good; to some centimetres, along
/// the line of sight to a tenth of the distance, sometimes to a third.
///
/// Nothing where no plane holds a fifth of the points, little stands on it, or so low that it hardly tells how far it
/// is, no place makes its holes well or all of them lie under things, as where cameras at all sides saw it, or where
/// points would be hidden from there.
std::optional<Eigen::Isometry3d> findCameraByShadows(const Cloud& list);

}  // namespace primitect
