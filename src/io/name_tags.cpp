// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Greedy placement of names.
#include "io/name_tags.h"

#include <algorithm>
#include <cmath>
#include <limits>
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

/// Counts things below boxes, by sums over all cells up to a corner.
class HiddenThings {
 public:
  explicit HiddenThings(const Things& things) : cell_(things.cell) {
    if (!things.cells.empty()) cv::integral(things.cells, sums_, CV_32S);
  }

  /// px^2.
  double areaBelow(const cv::Rect& box) const {
    if (sums_.empty()) return 0.0;
    const auto at = [this](int x, int y) {
      return sums_.at<int>(std::min(y / cell_, sums_.rows - 1), std::min(x / cell_, sums_.cols - 1));
    };
    const cv::Point begin = box.tl(), end = box.br() + cv::Point(cell_ - 1, cell_ - 1);
    const int cells = at(end.x, end.y) - at(begin.x, end.y) - at(end.x, begin.y) + at(begin.x, begin.y);
    return static_cast<double>(cells) * cell_ * cell_;
  }

 private:
  cv::Mat sums_;
  int cell_;
};

/// Tries places on growing rings around the anchor, upwards first, and takes the one where least is hidden and that is
/// not far away for it: to hide as much as the square of its height is as bad as to be its height farther away.
cv::Rect placeOne(std::size_t self, const std::vector<cv::Point>& anchors, const cv::Size& size,
                  const HiddenThings& things, const cv::Size& picture, const std::vector<cv::Rect>& taken) {
  constexpr int kRings = 24, kDirections = 12;
  constexpr double kOfAnchor = 4.0;
  const cv::Point anchor = anchors[self];
  cv::Rect best = boxAround(anchor, size, picture);
  double least = std::numeric_limits<double>::infinity();
  for (int ring = 1; ring <= kRings && ring < least; ++ring) {
    for (int i = 0; i < kDirections; ++i) {
      const double turn = (i % 2 == 0 ? 1 : -1) * ((i + 1) / 2) * 2.0 * M_PI / kDirections;
      const double across = 0.8 * ring * size.height * std::sin(turn) * 2.0;
      const double up = ring * size.height * std::cos(turn);
      const cv::Point middle(anchor.x + static_cast<int>(across), anchor.y - static_cast<int>(up));
      const cv::Rect box = boxAround(middle, size, picture);
      if (!clear(box, taken)) continue;
      const auto hides = [&box](const cv::Point& other) { return box.contains(other); };
      const double cost = ring + things.areaBelow(box) / (size.height * size.height) +
                          kOfAnchor * static_cast<double>(std::count_if(anchors.begin(), anchors.end(), hides));
      if (cost < least) least = cost, best = box;
    }
  }
  return best;
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
                                const Things& things, const cv::Size& picture) {
  const HiddenThings hidden(things);
  std::vector<cv::Rect> boxes;
  for (std::size_t i = 0; i < anchors.size(); ++i) {
    boxes.push_back(placeOne(i, anchors, sizes[i], hidden, picture, boxes));
  }
  return boxes;
}

void drawTags(cv::Mat& picture, const std::vector<NameTag>& tags, const Things& things) {
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
  const std::vector<cv::Rect> boxes = placeTags(anchors, sizes, things, picture.size());
  for (std::size_t i = 0; i < tags.size(); ++i) {
    const cv::Point middle = (boxes[i].tl() + boxes[i].br()) / 2;
    cv::line(picture, tags[i].anchor, middle, cv::Scalar::all(255), 2, cv::LINE_AA);
    cv::circle(picture, tags[i].anchor, 4, cv::Scalar::all(255), cv::FILLED, cv::LINE_AA);
    cv::circle(picture, tags[i].anchor, 3, tags[i].color, cv::FILLED, cv::LINE_AA);
  }
  for (std::size_t i = 0; i < tags.size(); ++i) drawTag(picture, tags[i], boxes[i], scale);
}

}  // namespace primitect::io
