// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Images whose points were moved to another frame, and where their camera was.
#pragma once

#include <Eigen/Geometry>
#include <optional>

#include "primitect/cloud.h"

namespace primitect {

/// An organized cloud, cut in depth or not, is not what a pinhole camera at the origin sees along z, by its rows and
/// columns, or because it lies behind, or nothing is left of it: it is worth while to ask findCamera().
bool isMovedImage(const Cloud& cloud);

/// The camera's optical frame (z ahead, x right, y down) in the frame of the points, of which none was cut off. From
/// columns, rows and some hundred points (m), by the direct linear transform (Hartley and Zisserman, Multiple View
/// Geometry, 2004, 7.1), and again without strays, which may be one in ten; noise of the depth moves points along their
/// rays, and does no harm. Nothing where the cloud is not organized, points lie exactly in a plane or are too few to
/// tell, no pinhole camera sees them where they are in the image to a third of a pixel, or only one whose pixels or
/// principal point no camera has; nor where the camera is at the origin and looks along z, to 3 mm and 3 mrad.
std::optional<Eigen::Isometry3d> findCamera(const Cloud& cloud);

}  // namespace primitect
