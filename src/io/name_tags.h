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

/// What names should not hide.
struct Things {
  cv::Mat cells;  ///< CV_8UC1, 1 where there is something, from the upper left corner of the picture on; or empty
  int cell = 1;   ///< px, their side
};

/// A box for each tag of that size, near its anchor (above it where there is room), within the picture and clear of the
/// boxes of earlier tags as long as the picture has room; rather a little farther away than over things and other
/// anchors.
std::vector<cv::Rect> placeTags(const std::vector<cv::Point>& anchors, const std::vector<cv::Size>& sizes,
                                const Things& things, const cv::Size& picture);

/// Draws white text on boxes of the tag's colour; a line leads to the anchor.
void drawTags(cv::Mat& picture, const std::vector<NameTag>& tags, const Things& things);

/// Size of text in a picture of that width: the picture may be scaled down to a third and can still be read.
double textScale(int picture_width);

}  // namespace primitect::io
