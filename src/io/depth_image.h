// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// A 16-bit depth PNG to an organized cloud.
#pragma once

#include <string>

#include "io/file_checks.h"
#include "io/point_files.h"

namespace primitect::io {

/// 0 is missing. The arithmetic is depth_image_proc's in float32, so that a recorded depth image gives the same points
/// here and through ROS. Throws FileError naming the cause, std::invalid_argument for a depth scale that is not above
/// 0.
Cloud readDepthImage(const std::string& path, const FileHead& head, const DepthImageOptions& options);

}  // namespace primitect::io
