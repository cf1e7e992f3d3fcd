// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// What was found in one frame, in another one.
#pragma once

#include <Eigen/Geometry>

#include "primitect/primitives.h"

namespace primitect {

/// The same shape in another frame.
Shape transformed(const Eigen::Isometry3d& target_from_source, const Shape& shape);

/// Moves shapes, extents and covariances.
void transformDetections(const Eigen::Isometry3d& target_from_source, Detections& detections);

/// Of a pose, 6 x 6 row-major, about the fixed axes of a frame that is turned; an unknown one ([0] = -1) stays so.
void turnCovariance(const Eigen::Matrix3d& rotation, double* covariance);

}  // namespace primitect
