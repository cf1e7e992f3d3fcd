// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The points of a picture: shaded, tinted where they belong to a detection.
#pragma once

#include <cstdint>
#include <opencv2/core.hpp>
#include <vector>

#include "io/view.h"
#include "primitect/cloud.h"
#include "primitect/primitives.h"

namespace primitect::io {

/// A cloud and what is known of its points; the cloud is the whole one, not cut at any depth.
struct LabelledPoints {
  const Cloud& cloud;
  DepthRange used;                           ///< points outside are drawn dark
  const std::vector<std::uint32_t>& labels;  ///< index of the detection + 1, 0 = none; as long as the cloud
  const Detections& detections;
};

cv::Scalar bgr(Kind kind);

/// An organized cloud as its camera saw it, `scale` pixels a point, missing points black.
cv::Mat drawImage(const LabelledPoints& points, int scale);

/// Any cloud, its points as dots, the nearer ones in front.
cv::Mat drawDots(const LabelledPoints& points, const View& view);

}  // namespace primitect::io
