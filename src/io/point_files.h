// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Point files to clouds: PCD, PLY and 16-bit depth PNG.
#pragma once

#include <optional>
#include <string>

#include "io/intrinsics.h"
#include "io/sensor_pose.h"
#include "primitect/cloud.h"

namespace primitect::io {

/// What a depth PNG does not say itself.
struct DepthImageOptions {
  std::optional<Intrinsics> intrinsics;
  double depth_scale = 0.001;  ///< metres per unit
};

/// A file as it was read, not cut at any depth.
struct PointFile {
  Cloud cloud;
  std::optional<Intrinsics> intrinsics;  ///< of a depth image
  std::optional<SensorPose> viewpoint;   ///< of a PCD that tells one, other than the identity; not applied
};

/// Reads .pcd, .ply (ascii, binary; float32 or float64 x y z in any order; normal_x, normal_y, normal_z, in a PLY nx,
/// ny, nz, if there) or .png. Organized PCDs and range grids keep width and height. Throws
/// std::runtime_error, one line naming file and cause, for whatever is not such a file.
PointFile readPointFile(const std::string& path, const DepthImageOptions& options = {});

/// True for a name that ends in .png.
bool isDepthImage(const std::string& path);

/// Copies into `cut` with all points outside the range missing: what a node does with its input.
void cutAtDepth(const Cloud& cloud, const DepthRange& range, Cloud& cut);

}  // namespace primitect::io
