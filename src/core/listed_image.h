// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Lists that keep the points of an image row by row, as filters leave them, in whatever frame: their order alone tells
// pixels, and with these the camera.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "primitect/cloud.h"
#include "primitect/primitives.h"

namespace primitect {

/// A point, and where it was seen.
struct SeenPoint {
  Vec3 point;             ///< m
  Eigen::Vector2d pixel;  ///< column and row
};

/// Some hundred points of a list with their pixels, counted from any column and row; columns may run across or down,
/// and either way. Few or none where the order of the points tells no pixels: they are shuffled, averaged by a voxel
/// grid, or come from several cameras. Where it only seems to tell them, no camera sees the points there.
///
/// Noise moves the points of a depth camera along their rays, so their places in the image are exact, and from them
/// follows where the camera is: on the axis of row_axis.h. With s along it, t the distance from it and phi the angle
/// around it, s = s0 at the centre, columns are (s - s0) / (t cos(phi - phi0)) but for their width. From one to the
/// next d(s/t) = s0 d(1/t) + a cos phi + b sin phi, linear in s0 and in a and b, which tell their width and where the
/// camera looks. Rows are what is left: y/z of the points is on a lattice.
std::vector<SeenPoint> findPixels(const Cloud& list);

}  // namespace primitect
