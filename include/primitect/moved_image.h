// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Images whose points were moved to another frame, also those of which a filter left a list, and where their camera
// was.
#pragma once

#include <Eigen/Geometry>
#include <optional>

#include "primitect/cloud.h"

namespace primitect {

/// What is at the origin of the frame that a cloud is in.
enum class Origin {
  camera,     ///< that saw it, along z, up to a turn around z
  elsewhere,  ///< something else, it seems: it is worth while to ask findCamera(), with nothing cut off
  unknown     ///< a list of points whose order tells nothing
};

/// Of a cloud that was cut in depth, or not. An organized cloud was moved where it is not what a pinhole camera at the
/// origin sees along z, by its rows and columns, or because it lies behind, or nothing is left of it; a list where
/// findCamera() finds it so, or where most of it was cut off, perhaps along another axis than that of the camera.
Origin originOf(const Cloud& cloud);

/// The camera's optical frame (z ahead, x right, y down) in the frame of the points, of which none was cut off. From
/// columns, rows and some hundred points (m), by the direct linear transform (Hartley and Zisserman, Multiple View
/// Geometry, 2004, 7.1), and again without strays, which may be one in ten; noise of the depth moves points along their
/// rays, and does no harm. Of a list the order of its points tells columns and rows (core/listed_image.h), as long as
/// it is that of the image: after filters that leave points out, not after averages (a voxel grid) or shuffling. Which
/// side of the image is up it cannot tell.
///
/// Nothing where points lie exactly in a plane or are too few to tell, no pinhole camera sees them where they are in
/// the image to a third of a pixel (of lists to a tenth), or only one whose pixels or principal point no camera has.
std::optional<Eigen::Isometry3d> findCamera(const Cloud& cloud);

/// It is the origin, and looks along z, to 3 mm and 3 mrad: a poor lens there shifts what is found by some millimetres.
/// Turns around z are none of lists.
bool isAtOrigin(const Eigen::Isometry3d& cloud_from_camera, const Cloud& cloud);

}  // namespace primitect
