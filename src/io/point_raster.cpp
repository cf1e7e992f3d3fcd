// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Shading and tinting of points.
#include "io/point_raster.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>

#include "io/kind_color.h"

namespace primitect::io {
namespace {

constexpr double kTint = 0.45;     // opacity of the kind's colour over the shaded point
constexpr double kUnused = 0.35;   // brightness of points outside the depth range
constexpr double kAmbient = 0.35;  // brightness of a surface seen edge-on

using Point3 = Eigen::Vector3f;

Point3 pointOf(const Cloud& cloud, std::size_t i) { return {cloud.x[i], cloud.y[i], cloud.z[i]}; }

/// Depths from near (brightest) to far, without strays.
struct DepthFade {
  double near = 0.0, far = 1.0;

  explicit DepthFade(std::vector<float> depths) {
    if (depths.empty()) return;
    std::sort(depths.begin(), depths.end());
    near = depths[depths.size() / 50];
    far = std::max(near + 1e-6, static_cast<double>(depths[depths.size() - 1 - depths.size() / 50]));
  }
  double brightness(double depth) const { return 1.0 - 0.45 * std::clamp((depth - near) / (far - near), 0.0, 1.0); }
};

/// 1 for a surface that faces the viewer, from the differences to points `step` pixels away.
double facing(const Cloud& cloud, std::size_t column, std::size_t row) {
  constexpr std::size_t step = 3;
  if (column < step || row < step || column + step >= cloud.width || row + step >= cloud.height) return 0.5;
  const std::size_t i = row * cloud.width + column;
  const Point3 across = pointOf(cloud, i + step) - pointOf(cloud, i - step);
  const Point3 along = pointOf(cloud, i + step * cloud.width) - pointOf(cloud, i - step * cloud.width);
  const Point3 normal = across.cross(along);
  const float cosine = std::abs(normal.dot(pointOf(cloud, i))) / (normal.norm() * pointOf(cloud, i).norm());
  return std::isfinite(cosine) ? cosine : 0.5;
}

/// The label's kind tints a grey of that brightness.
cv::Vec3b color(const LabelledPoints& points, std::size_t i, double brightness) {
  const double grey = 255.0 * brightness;
  const std::uint32_t label = i < points.labels.size() ? points.labels[i] : 0;
  if (!points.used.contains(points.cloud.z[i])) return cv::Vec3b::all(cv::saturate_cast<std::uint8_t>(kUnused * grey));
  if (label == 0 || label > points.detections.items.size())
    return cv::Vec3b::all(cv::saturate_cast<std::uint8_t>(grey));
  const cv::Scalar tint = bgr(kindOf(points.detections.items[label - 1].shape));
  cv::Vec3b mixed;
  for (int c = 0; c < 3; ++c) {
    mixed[c] = cv::saturate_cast<std::uint8_t>((1.0 - kTint) * grey + kTint * tint[c] * (0.4 + 0.6 * brightness));
  }
  return mixed;
}

std::vector<float> depthsOf(const Cloud& cloud, const View& view) {
  std::vector<float> depths;
  depths.reserve(cloud.valid_count);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (cloud.valid(i)) depths.push_back(static_cast<float>(view.depth(pointOf(cloud, i).cast<double>())));
  }
  return depths;
}

/// Point of each pixel, -1 for none.
cv::Mat nearestPoints(const Cloud& cloud, const View& view) {
  cv::Mat nearest(view.height, view.width, CV_32SC1, cv::Scalar(-1));
  cv::Mat depth(view.height, view.width, CV_32FC1, cv::Scalar(std::numeric_limits<float>::max()));
  const double spacing = std::sqrt(static_cast<double>(view.width) * view.height / std::max(1u, cloud.valid_count));
  const int half = std::clamp(static_cast<int>(std::lround(0.6 * spacing)), 0, 3);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (!cloud.valid(i)) continue;
    const Vec3 p = pointOf(cloud, i).cast<double>();
    const auto pixel = view.project(p);
    if (!pixel || !(pixel->cwiseAbs().maxCoeff() < 1e6)) continue;
    const float z = static_cast<float>(view.depth(p));
    const int u = static_cast<int>(std::lround(pixel->x())), v = static_cast<int>(std::lround(pixel->y()));
    for (int row = std::max(0, v - half); row <= std::min(view.height - 1, v + half); ++row) {
      for (int column = std::max(0, u - half); column <= std::min(view.width - 1, u + half); ++column) {
        if (!(z < depth.at<float>(row, column))) continue;
        depth.at<float>(row, column) = z;
        nearest.at<int>(row, column) = static_cast<int>(i);
      }
    }
  }
  return nearest;
}

}  // namespace

cv::Scalar bgr(Kind kind) {
  const Rgb rgb = kindColor(kind);
  return {static_cast<double>(rgb.blue), static_cast<double>(rgb.green), static_cast<double>(rgb.red)};
}

cv::Mat drawImage(const LabelledPoints& points, int scale) {
  const Cloud& cloud = points.cloud;
  const DepthFade fade(depthsOf(cloud, View{}));
  cv::Mat image(static_cast<int>(cloud.height), static_cast<int>(cloud.width), CV_8UC3, cv::Scalar::all(0));
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (!cloud.valid(i)) continue;
    const std::size_t column = i % cloud.width, row = i / cloud.width;
    const double brightness = (kAmbient + (1.0 - kAmbient) * facing(cloud, column, row)) * fade.brightness(cloud.z[i]);
    image.at<cv::Vec3b>(static_cast<int>(row), static_cast<int>(column)) = color(points, i, brightness);
  }
  cv::Mat scaled;
  cv::resize(image, scaled, cv::Size(), scale, scale, cv::INTER_NEAREST);
  return scaled;
}

cv::Mat drawDots(const LabelledPoints& points, const View& view) {
  const Cloud& cloud = points.cloud;
  const DepthFade fade(depthsOf(cloud, view));
  const cv::Mat nearest = nearestPoints(cloud, view);
  cv::Mat image(view.height, view.width, CV_8UC3, cv::Scalar::all(0));
  for (int row = 0; row < view.height; ++row) {
    for (int column = 0; column < view.width; ++column) {
      const int point = nearest.at<int>(row, column);
      if (point < 0) continue;
      const std::size_t i = static_cast<std::size_t>(point);
      double turned = 1.0;
      if (cloud.hasNormals() && std::isfinite(cloud.nx[i])) {
        turned = std::abs(view.forward.dot(Vec3(cloud.nx[i], cloud.ny[i], cloud.nz[i])));
      }
      const double brightness = fade.brightness(view.depth(pointOf(cloud, i).cast<double>()));
      image.at<cv::Vec3b>(row, column) = color(points, i, (kAmbient + (1.0 - kAmbient) * turned) * brightness);
    }
  }
  return image;
}

}  // namespace primitect::io
