// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Greedy placement of names.
#include "io/name_tags.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace primitect::io {
namespace {

constexpr int kFont = cv::FONT_HERSHEY_SIMPLEX;
constexpr int kThickness = 2;

cv::Rect boxAround(const cv::Point& middle, const cv::Size& size, const cv::Size& picture) {
  const int x = std::clamp(middle.x - size.width / 2, 0, std::max(0, picture.width - size.width));
  const int y = std::clamp(middle.y - size.height / 2, 0, std::max(0, picture.height - size.height));
  return {cv::Point(x, y), size};
}

bool clear(const cv::Rect& box, const std::vector<cv::Rect>& others) {
  return std::none_of(others.begin(), others.end(), [&](const cv::Rect& other) { return (box & other).area() > 0; });
}

/// Tries places on growing rings around the anchor, upwards first.
cv::Rect placeOne(const cv::Point& anchor, const cv::Size& size, const cv::Size& picture,
                  const std::vector<cv::Rect>& taken) {
  constexpr int kRings = 24, kDirections = 12;
  for (int ring = 1; ring <= kRings; ++ring) {
    for (int i = 0; i < kDirections; ++i) {
      const double turn = (i % 2 == 0 ? 1 : -1) * ((i + 1) / 2) * 2.0 * M_PI / kDirections;
      const double across = 0.8 * ring * size.height * std::sin(turn) * 2.0;
      const double up = ring * size.height * std::cos(turn);
      const cv::Point middle(anchor.x + static_cast<int>(across), anchor.y - static_cast<int>(up));
      const cv::Rect box = boxAround(middle, size, picture);
      if (clear(box, taken)) return box;
    }
  }
  return boxAround(anchor, size, picture);
}

void drawTag(cv::Mat& picture, const NameTag& tag, const cv::Rect& box, double scale) {
  const int pad = box.height / 5;
  cv::rectangle(picture, box, tag.color, cv::FILLED);
  cv::rectangle(picture, box, cv::Scalar::all(255), 1);
  cv::putText(picture, tag.text, {box.x + pad, box.y + box.height - static_cast<int>(1.6 * pad)}, kFont, scale,
              cv::Scalar::all(255), kThickness, cv::LINE_AA);
}

}  // namespace

double textScale(int picture_width) { return std::max(0.45, picture_width / 1700.0); }

std::vector<cv::Rect> placeTags(const std::vector<cv::Point>& anchors, const std::vector<cv::Size>& sizes,
                                const cv::Size& picture) {
  std::vector<cv::Rect> boxes;
  for (std::size_t i = 0; i < anchors.size(); ++i) boxes.push_back(placeOne(anchors[i], sizes[i], picture, boxes));
  return boxes;
}

void drawTags(cv::Mat& picture, const std::vector<NameTag>& tags) {
  const double scale = textScale(picture.cols);
  std::vector<cv::Point> anchors;
  std::vector<cv::Size> sizes;
  for (const NameTag& tag : tags) {
    int baseline = 0;
    const cv::Size text = cv::getTextSize(tag.text, kFont, scale, kThickness, &baseline);
    const int height = text.height * 5 / 3 + baseline / 2;
    sizes.emplace_back(text.width + 2 * (height / 5), height);
    anchors.push_back(tag.anchor);
  }
  const std::vector<cv::Rect> boxes = placeTags(anchors, sizes, picture.size());
  for (std::size_t i = 0; i < tags.size(); ++i) {
    const cv::Point middle = (boxes[i].tl() + boxes[i].br()) / 2;
    cv::line(picture, tags[i].anchor, middle, cv::Scalar::all(255), 2, cv::LINE_AA);
    cv::circle(picture, tags[i].anchor, 4, cv::Scalar::all(255), cv::FILLED, cv::LINE_AA);
    cv::circle(picture, tags[i].anchor, 3, tags[i].color, cv::FILLED, cv::LINE_AA);
  }
  for (std::size_t i = 0; i < tags.size(); ++i) drawTag(picture, tags[i], boxes[i], scale);
}

}  // namespace primitect::io
