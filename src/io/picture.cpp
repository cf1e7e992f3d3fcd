// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Layers of a picture: points, outlines, names; the caption below it.
#include "io/picture.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "io/outlines.h"
#include "io/percent_text.h"
#include "io/picture_caption.h"
#include "io/png_image.h"
#include "io/shape_text.h"

namespace primitect::io {
namespace {

constexpr int kPictureWidth = 1280, kPictureHeight = 960;  // px; small images are scaled up to about that width

void drawLines(cv::Mat& picture, const std::vector<Line2>& lines, const cv::Scalar& color) {
  constexpr int kShift = 4;  // sixteenths of a pixel
  const int width = std::max(1, picture.cols / 420);
  for (const int pass : {0, 1}) {
    for (const Line2& line : lines) {
      std::vector<cv::Point> corners;
      for (const Eigen::Vector2d& corner : line) {
        const Eigen::Vector2d held = corner.cwiseMax(-1e6).cwiseMin(1e6) * (1 << kShift);
        corners.emplace_back(static_cast<int>(std::lround(held.x())), static_cast<int>(std::lround(held.y())));
      }
      // A dark rim keeps the line visible on its own tint.
      cv::polylines(picture, corners, false, pass == 0 ? cv::Scalar::all(20) : color, pass == 0 ? width + 3 : width,
                    cv::LINE_AA, kShift);
    }
  }
}

constexpr int kCell = 8;  // px; places of names are sought on a coarse grid

/// Which detection + 1 the points in each cell belong to; 0 = none.
cv::Mat labelCells(const LabelledPoints& points, const View& view) {
  cv::Mat cells(view.height / kCell + 1, view.width / kCell + 1, CV_32SC1, cv::Scalar(0));
  for (std::size_t i = 0; i < points.cloud.size() && i < points.labels.size(); ++i) {
    if (points.labels[i] == 0 || !points.cloud.valid(i)) continue;
    const auto pixel = view.project({points.cloud.x[i], points.cloud.y[i], points.cloud.z[i]});
    const bool inside = pixel && pixel->minCoeff() >= 0.0 && pixel->x() < view.width && pixel->y() < view.height;
    if (!inside) continue;
    int& cell = cells.at<int>(static_cast<int>(pixel->y()) / kCell, static_cast<int>(pixel->x()) / kCell);
    // Curved shapes stand in front of planes.
    const bool plane = kindOf(points.detections.items.at(points.labels[i] - 1).shape) == Kind::plane;
    if (cell == 0 || !plane) cell = static_cast<int>(points.labels[i]);
  }
  return cells;
}

/// Where the name of a detection points to: the middle of the largest free disc of its points in the picture, else the
/// origin of its extent.
std::vector<cv::Point> anchorsOf(const LabelledPoints& points, const cv::Mat& cells, const View& view) {
  std::vector<cv::Point> anchors;
  for (std::size_t i = 0; i < points.detections.items.size(); ++i) {
    cv::Mat own, room;
    cv::copyMakeBorder(cells == static_cast<int>(i + 1), own, 1, 1, 1, 1, cv::BORDER_CONSTANT, cv::Scalar(0));
    cv::distanceTransform(own, room, cv::DIST_L2, cv::DIST_MASK_5);
    double most = 0.0;
    cv::Point cell;
    cv::minMaxLoc(room, nullptr, &most, nullptr, &cell);
    Eigen::Vector2d place(kCell * (cell.x - 0.5), kCell * (cell.y - 0.5));
    if (most == 0.0) {
      place = view.project(points.detections.items[i].extent.origin).value_or(Eigen::Vector2d::Zero());
    }
    anchors.emplace_back(static_cast<int>(std::clamp(place.x(), 0.0, view.width - 1.0)),
                         static_cast<int>(std::clamp(place.y(), 0.0, view.height - 1.0)));
  }
  return anchors;
}

/// Which cells show small things, such as names should not hide; of a table or wall they may.
cv::Mat smallThings(std::size_t detections, const cv::Mat& cells) {
  constexpr double kLarge = 0.08;  // of the picture
  cv::Mat things(cells.size(), CV_8UC1, cv::Scalar(0));
  for (std::size_t i = 0; i < detections; ++i) {
    const cv::Mat own = cells == static_cast<int>(i + 1);
    if (cv::countNonZero(own) < kLarge * static_cast<double>(cells.total())) things.setTo(1, own);
  }
  return things;
}

std::vector<NameTag> tagsAt(const std::vector<cv::Point>& anchors, const LabelledPoints& points) {
  std::vector<NameTag> tags;
  for (const bool planes : {false, true}) {
    for (std::size_t i = 0; i < anchors.size(); ++i) {
      const Detection& detection = points.detections.items[i];
      const Kind kind = kindOf(detection.shape);
      if ((kind == Kind::plane) != planes) continue;
      const std::string confidence = percentText(detection.confidence);
      const std::string name = std::to_string(i + 1) + "  " + nameText(detection);
      tags.push_back({name + (confidence.empty() ? "" : "  " + confidence), anchors[i], bgr(kind)});
    }
  }
  return tags;
}

}  // namespace

std::vector<NameTag> tagsOf(const LabelledPoints& points, const View& view) {
  return tagsAt(anchorsOf(points, labelCells(points, view), view), points);
}

cv::Mat drawPicture(const LabelledPoints& points, const std::optional<Intrinsics>& lens, const std::string& title) {
  const Cloud& cloud = points.cloud;
  const std::optional<Intrinsics> camera = lens && cloud.organized() ? lens : estimateIntrinsics(cloud);
  View view;
  cv::Mat picture;
  if (camera) {
    // The longer side: an image can be a strip.
    const double side = std::max(cloud.width, cloud.height);
    const int scale = std::max(1, static_cast<int>(std::lround(kPictureWidth / side)));
    view = cameraView(*camera, cloud.width, cloud.height, scale);
    picture = drawImage(points, scale);
  } else {
    view = orthographicView(cloud, kPictureWidth, kPictureHeight);
    picture = drawDots(points, view);
  }
  for (const Detection& detection : points.detections.items) {
    drawLines(picture, projectLines(outlineOf(detection, view), view), bgr(kindOf(detection.shape)));
  }
  const cv::Mat cells = labelCells(points, view);
  drawTags(picture, tagsAt(anchorsOf(points, cells, view), points),
           {smallThings(points.detections.items.size(), cells), kCell});
  constexpr int kLeastWidth = 320;  // px: what the caption can be read in
  const int missing = std::max(0, kLeastWidth - picture.cols);
  if (missing > 0) cv::copyMakeBorder(picture, picture, 0, 0, 0, missing, cv::BORDER_CONSTANT, cv::Scalar::all(30));
  cv::vconcat(picture, drawCaption(points, title, picture.cols), picture);
  return picture;
}

void writePicture(const std::string& path, const cv::Mat& picture) {
  try {
    writePicturePng(path, picture.data, static_cast<std::uint32_t>(picture.cols),
                    static_cast<std::uint32_t>(picture.rows), picture.step);
  } catch (const PngError& error) {
    throw std::runtime_error(path + ": cannot be written as a picture (" + error.what() + ")");
  }
}

}  // namespace primitect::io
