// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// A picture of a frame with all that was found in it, for people.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "io/intrinsics.h"
#include "io/name_tags.h"
#include "io/point_raster.h"
#include "io/view.h"

namespace primitect::io {

/// An organized cloud as its camera saw it: shaded points, tinted where they belong to a detection, outlines of all
/// detections in their kind's colour, numbered names with sizes and confidence, and a line that says what is what.
/// Without intrinsics they are estimated; a cloud that is no camera image is drawn as dots, orthographically. Returns
/// 8-bit BGR.
cv::Mat drawPicture(const LabelledPoints& points, const std::optional<Intrinsics>& lens, const std::string& title);

/// Number in the list of detections from 1 on (as in labels and in the text of `detect`), name, size and confidence of
/// each at a place of its points. Small things first, planes last: what comes first is named nearest to its place.
std::vector<NameTag> tagsOf(const LabelledPoints& points, const View& view);

/// Throws std::runtime_error naming the file when it cannot be written.
void writePicture(const std::string& path, const cv::Mat& picture);

}  // namespace primitect::io
