// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// What stands below a picture.
#pragma once

#include <opencv2/core.hpp>
#include <string>

#include "io/point_raster.h"

namespace primitect::io {

/// Title, counts of each kind in its colour, then what the shades mean; in as many rows as the width (px) asks for. Of
/// a title that is longer than a row the end is shown.
cv::Mat drawCaption(const LabelledPoints& points, const std::string& title, int width);

}  // namespace primitect::io
