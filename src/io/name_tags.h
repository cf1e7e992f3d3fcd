// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Names in a picture, placed so that each can be read.
#pragma once

#include <opencv2/core.hpp>
#include <string>
#include <vector>

namespace primitect::io {

/// A name and the place that it belongs to (px).
struct NameTag {
  std::string text;
  cv::Point anchor;
  cv::Scalar color;
};

/// A box for each tag of that size, near its anchor (above it where there is room), within the picture and clear of the
/// boxes of earlier tags as long as the picture has room.
std::vector<cv::Rect> placeTags(const std::vector<cv::Point>& anchors, const std::vector<cv::Size>& sizes,
                                const cv::Size& picture);

/// Draws white text on boxes of the tag's colour; a line leads to the anchor.
void drawTags(cv::Mat& picture, const std::vector<NameTag>& tags);

/// Size of text in a picture of that width: the picture may be scaled down to a third and can still be read.
double textScale(int picture_width);

}  // namespace primitect::io
