// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// A picture of a frame with all that was found in it, for people.
#pragma once

#include <optional>
#include <string>

#include "io/intrinsics.h"
#include "io/point_raster.h"

namespace primitect::io {

/// An organized cloud as its camera saw it: shaded points, tinted where they belong to a detection, outlines of all
/// detections in their kind's colour, names with sizes and confidence, and a line that says what is what. Without
/// intrinsics they are estimated; a cloud that is no camera image is drawn as dots, orthographically. Returns 8-bit
/// BGR.
cv::Mat drawPicture(const LabelledPoints& points, const std::optional<Intrinsics>& lens, const std::string& title);

/// Throws std::runtime_error naming the file when it cannot be written.
void writePicture(const std::string& path, const cv::Mat& picture);

}  // namespace primitect::io
