// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Images whose points were moved to another frame, also those of which a filter left a list, and where their camera
// was.
#pragma once

#include <Eigen/Geometry>
#include <optional>

#include "primitect/cloud.h"

namespace primitect {

/// The camera's optical frame (z ahead, x right, y down) in the frame of the points, of which none was cut off. From
/// columns, rows and some hundred points (m), by the direct linear transform (Hartley and Zisserman, Multiple View
/// Geometry, 2004, 7.1), and again without strays, which may be one in ten; noise of the depth moves points along their
/// rays, and does no harm. Of a list the order of its points tells columns and rows (core/listed_image.h), as long as
/// it is that of the image: after filters that leave points out, not after averages (a voxel grid), shuffling or
/// rounding. Which side of the image is up it cannot tell.
///
/// Nothing where points lie exactly in a plane or are too few to tell, no pinhole camera sees them where they are in
/// the image to a third of a pixel (of lists to a tenth), or only one whose pixels or principal point no camera has.
std::optional<Eigen::Isometry3d> findCamera(const Cloud& cloud);

/// By how much (rad) its axes are turned against those of the cloud; of a list, which does not tell which side of its
/// image is up, how far z is.
double turnOf(const Eigen::Isometry3d& cloud_from_camera, bool of_list);

/// It is the origin, and looks along z: images to 3 mm and 3 mrad, lists, of which less is known, to 10 and 10, and up
/// to a turn around z. A poor lens there shifts what is found by some millimetres.
bool isAtOrigin(const Eigen::Isometry3d& cloud_from_camera, const Cloud& cloud);

/// What told where a camera is: rows and columns of an image, the order of a list, or what it does not see of a plane.
enum class CameraClue { image, order, shadows };

/// What the points of a cloud tell of their camera.
struct CameraSearch {
  bool at_origin = false;                              ///< it is there, and looks along z
  std::optional<Eigen::Isometry3d> cloud_from_camera;  ///< it is elsewhere
  CameraClue clue = CameraClue::image;                 ///< of one that is elsewhere
};

/// With findCamera(), of a cloud in which nothing was cut off; of a list without normals whose order tells nothing, and
/// which was not seen from the origin, with findCameraByShadows() (core/shadows.h), to some centimetres.
CameraSearch searchForCamera(const Cloud& whole);

/// Of a cloud in which depths were cut along z, perhaps of the wrong frame. An image is not looked at further where it
/// is what a pinhole camera at the origin sees along z, by its rows and columns; of a list findCamera() looks at what
/// the cut left, if it left half, and shadows where it left all. Nothing: the cloud must be looked at with nothing cut
/// off.
std::optional<CameraSearch> searchForCameraInCut(const Cloud& cut);

}  // namespace primitect
